// SPDX-License-Identifier: GPL-3.0-or-later

#include "opticalSensor.H"
#include "HashSet.H"
#include "mathematicalConstants.H"

void Foam::functionObjects::opticalSensor::trackBodies()
{
    const vector& displacement = bodies_.window().displacement();

    traces_.clear();
    traceTime_ = bodies_.clock();

    for (label bodyi = 0; bodyi < bodies_.size(); ++bodyi)
    {
        const immersedBody& body = bodies_[bodyi];
        const scalar V = body.shape().volume()/constant::mathematical::pi;

        traces_.insert
        (
            body.number(),
            trace
            {
                body.motion().unwrapped() + displacement,
                body.state().U,
                bodies_.space().twoD() ? Foam::sqrt(V) : Foam::cbrt(0.75*V),
                body.name()
            }
        );
    }
}


void Foam::functionObjects::opticalSensor::follow
(
    const label number,
    const point& x,
    const vector& U,
    DynamicList<passage>& passages
) const
{
    if (!traces_.found(number))
    {
        return;
    }

    const vector& displacement = bodies_.window().displacement();
    const trace& old = traces_[number];
    const bodyPath path(traceTime_, old.x, old.U, bodies_.clock(), x, U);

    forAll(planes_, planei)
    {
        const sensorPlane& plane = planes_[planei];

        for (auto& crossing : plane.crossings(path, distances_[planei]))
        {
            scalar radius, angle;

            // Where it is in the mesh
            crossing.x +=
                bodies_.periods().wrap(crossing.x - displacement).shift;
            plane.polar(crossing.x, radius, angle);

            if (radius <= plane.radius())
            {
                passages.append
                (
                    passage
                    {
                        planei, number, old.name, crossing, radius, angle,
                        old.R
                    }
                );
            }
        }
    }
}


void Foam::functionObjects::opticalSensor::writePassagesHeader()
{
    OFstream& os = file();

    writeHeader(os, "Planes, by number:");

    forAll(planes_, planei)
    {
        writeHeaderValue(os, Foam::name(planei), planes_[planei].name());
    }

    writeCommented(os, "time[s]");
    os  << tab << "plane" << tab << "body" << tab << "velocity_x[m/s]" << tab
        << "velocity_y[m/s]" << tab << "velocity_z[m/s]" << tab
        << "axial[m/s]" << tab << "radius[m]" << tab << "angle[deg]" << tab
        << "direction" << tab << "interval[s]" << tab << "spacing[m]" << tab
        << "signal" << tab << "planeName" << tab << "bodyName" << endl;

    writtenHeader_ = true;
}


void Foam::functionObjects::opticalSensor::count(const passage& one)
{
    const sensorPlane& plane = planes_[one.plane];
    const bodyPath::crossing& crossing = one.crossing;
    const scalar u = crossing.U & plane.axis();

    const passageStatistics::passage result = record_[one.plane].add
    (
        crossing.time, u, one.radius, crossing.x, one.R, plane.axis()
    );

    if (!writeToFile())
    {
        return;
    }

    OFstream& os = file();

    os  << crossing.time << tab << one.plane << tab << one.body;
    for (const scalar Ui : crossing.U)
    {
        os  << tab << Ui;
    }
    os  << tab << u << tab << one.radius << tab << one.angle << tab
        << crossing.direction << tab << result.interval << tab
        << mag(u)*result.interval << tab << result.signal << tab
        << plane.name() << tab << one.name << endl;
}


void Foam::functionObjects::opticalSensor::findPassages
(
    DynamicList<passage>& passages
) const
{
    const vector& displacement = bodies_.window().displacement();
    const scalar dt = time_.deltaTValue();

    // Not if time has passed without it, before a timeStart
    if (mag(bodies_.clock() - dt - traceTime_) >= 1e-3*dt)
    {
        return;
    }

    labelHashSet departed;

    for (const bodyDeparture& one : bodies_.departed())
    {
        follow(one.number, one.unwrapped + displacement, one.U, passages);
        departed.insert(one.number);
    }

    for (const immersedBody& body : bodies_.list())
    {
        // It may have entered again
        if (!departed.found(body.number()))
        {
            follow
            (
                body.number(),
                body.motion().unwrapped() + displacement,
                body.state().U,
                passages
            );
        }
    }
}


bool Foam::functionObjects::opticalSensor::execute()
{
    DynamicList<passage> passages;

    findPassages(passages);
    gather(passages);

    if (writeToFile() && !writtenHeader_)
    {
        writePassagesHeader();
    }
    for (const passage& one : passages)
    {
        count(one);
    }

    trackBodies();

    // The state of this time has been written without these passages
    if (time_.writeTime())
    {
        record_.write();
    }

    return true;
}
