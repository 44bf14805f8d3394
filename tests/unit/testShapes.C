// SPDX-License-Identifier: GPL-3.0-or-later

#include "testTools.H"
#include "EdgeMap.H"
#include "mathematicalConstants.H"
#include "proximityMonitor.H"

using namespace Foam;
using constant::mathematical::pi;
using testTools::difference;
using testTools::messageOf;
using testTools::near;
using testTools::shape;
using Catch::Matchers::Contains;

namespace
{

//- The area vectors of a closed surface sum to zero; its volume by the
//  divergence theorem
std::pair<vector, scalar> areaAndVolume
(
    const pointField& points,
    const faceList& faces
)
{
    vector area(Zero);
    scalar volume = 0;

    for (const face& f : faces)
    {
        const vector S(f.areaNormal(points));
        area += S;
        volume += (S & f.centre(points))/3;
    }

    return {area, volume};
}

//- Shapes other than the round ones, for the tests that all of them pass
struct shapeCase
{
    const char* text;
    geometricSpace space;

    //- Volume, and inertia about x, y, z
    scalar volume;
    vector inertia;

    //- Half the extent along x, y, z; zero for the empty direction
    vector half;

    //- Moves a point near the surface onto it
    point (*project)(const point&);
};

point onEllipsoid(const point& X, const vector& semiAxes)
{
    return X/mag(cmptDivide(X, semiAxes));
}

const std::vector<shapeCase> shapeCases
{
    {
        "type ellipse; semiAxes (1 0.4);", geometricSpace(2), 0.4*pi,
        {0, 0, 0.1*pi*1.16}, {1, 0.4, 0},
        [](const point& X) { return onEllipsoid(X, {1, 0.4, 1}); }
    },
    {
        "type ellipse; semiAxes (1 0.4);", geometricSpace(1), 0.4*pi,
        {0, 0.1*pi*1.16, 0}, {0.4, 0, 1},
        [](const point& X) { return onEllipsoid(X, {0.4, 1, 1}); }
    },
    {
        "type ellipsoid; semiAxes (0.5 1 0.3);", geometricSpace(-1), 0.2*pi,
        {0.04*pi*1.09, 0.04*pi*0.34, 0.04*pi*1.25}, {0.5, 1, 0.3},
        [](const point& X) { return onEllipsoid(X, {0.5, 1, 0.3}); }
    },
    {
        "type box; size (1 0.4 0);", geometricSpace(2), 0.4,
        {0, 0, 0.4*1.16/12}, {0.5, 0.2, 0},
        [](const point& X) { return X; }
    },
    {
        "type box; size (1 0.4 0.6);", geometricSpace(-1), 0.24,
        {0.02*0.52, 0.02*1.36, 0.02*1.16}, {0.5, 0.2, 0.3},
        [](const point& X) { return X; }
    },
    {
        "type cylinder; radius 0.5; length 0.8;", geometricSpace(-1), 0.2*pi,
        {
            0.2*pi*(0.0625 + 0.64/12), 0.2*pi*(0.0625 + 0.64/12),
            0.2*pi*0.125
        },
        {0.5, 0.5, 0.4},
        [](const point& X)
        {
            // Out to the circle of the corners between which the point is
            const scalar sector = pi/12;
            const scalar angle = std::atan2(X.y(), X.x());
            const scalar inSector =
                angle - sector*(std::floor(angle/sector) + 0.5);
            const scalar out = Foam::cos(inSector)/Foam::cos(0.5*sector);
            return point(out*X.x(), out*X.y(), X.z());
        }
    }
};


//- Points of the surface: in 3D spread over its faces, in 2D over its rim
pointField samples(const bodyShape& body, const shapeCase& c)
{
    pointField points;
    faceList faces;
    body.surface(points, faces);
    DynamicList<point> result;

    if (c.space.twoD())
    {
        EdgeMap<label> count;
        for (const face& f : faces)
        {
            for (const edge& e : f.edges())
            {
                ++count(e, 0);
            }
        }
        forAllConstIters(count, iter)
        {
            for (label i = 0; iter.val() == 1 && i < 20; ++i)
            {
                const edge& e = iter.key();
                const scalar s = 0.05*i;
                result.append
                (
                    c.project((1 - s)*points[e.start()] + s*points[e.end()])
                );
            }
        }
    }
    else
    {
        const label n = 12;
        for (const face& f : faces)
        {
            for (label i = 0; i <= n; ++i)
            {
                for (label j = 0; j <= n; ++j)
                {
                    const scalar s = scalar(i)/n, t = scalar(j)/n;
                    result.append
                    (
                        c.project
                        (
                            (1 - t)
                           *((1 - s)*points[f[0]] + s*points[f[1]])
                          + t*((1 - s)*points[f[3]] + s*points[f[2]])
                        )
                    );
                }
            }
        }
    }

    return pointField(result);
}


//- Volume and inertia from the points of a lattice where the distance is
//  negative; half is half the extent of the lattice, best one that puts plane
//  surfaces between its points
std::pair<scalar, vector> latticeSums
(
    const bodyShape& body,
    const vector& half,
    const label n
)
{
    Vector<label> N(n, n, n);
    scalar dV = 1;
    for (direction k = 0; k < 3; ++k)
    {
        N[k] = half[k] > 0 ? n : 1;
        dV *= half[k] > 0 ? 2*half[k]/n : 1;
    }

    scalar volume = 0;
    vector inertia(Zero);
    point X;

    for (label i = 0; i < N.x(); ++i)
    {
        for (label j = 0; j < N.y(); ++j)
        {
            for (label k = 0; k < N.z(); ++k)
            {
                X.x() = half.x()*((2*i + 1.0)/N.x() - 1);
                X.y() = half.y()*((2*j + 1.0)/N.y() - 1);
                X.z() = half.z()*((2*k + 1.0)/N.z() - 1);

                if (body.distance(X) < 0)
                {
                    volume += dV;
                    inertia += dV*(magSqr(X)*vector::one - cmptMultiply(X, X));
                }
            }
        }
    }

    return {volume, inertia};
}

} // End anonymous namespace


TEST_CASE("A space has its directions, plane and cell sizes", "[space]")
{
    const geometricSpace threeD(-1);

    CHECK_FALSE(threeD.twoD());
    CHECK(threeD.nDims() == 3);
    CHECK(threeD.emptyDir() == vector::zero);
    CHECK(threeD.translation() == vector::one);
    CHECK(threeD.rotation() == vector::one);
    CHECK(threeD.inPlane({1, 2, 3}) == vector(1, 2, 3));
    CHECK(threeD.cellSize(0.125) == near(0.5));

    const geometricSpace xy(2, 0.1);

    CHECK(xy.twoD());
    CHECK(xy.nDims() == 2);
    CHECK(xy.depth() == 0.1);
    CHECK(xy.emptyDir() == vector(0, 0, 1));
    CHECK(xy.translation() == vector(1, 1, 0));
    CHECK(xy.rotation() == vector(0, 0, 1));
    CHECK(xy.inPlane({1, 2, 3}) == vector(1, 2, 0));
    CHECK(xy.cellSize(0.025) == near(0.5));

    const geometricSpace xz(1);

    CHECK(xz.translation() == vector(1, 0, 1));
    CHECK(xz.rotation() == vector(0, 1, 0));
    CHECK(xz.inPlane({1, 2, 3}) == vector(1, 0, 3));
}


TEST_CASE("Disc: distance, normal, area, inertia", "[shapes]")
{
    const direction empty = GENERATE(0, 1, 2);
    const geometricSpace space(empty, 0.1);
    const auto disc = shape("type disc; radius 0.5;", space);

    // In the plane at distance 1.3 (5-12-13), with an offset out of it that
    // does not count
    vector X(Zero), n(Zero);
    X[(empty + 1) % 3] = n[(empty + 1) % 3] = 0.5;
    X[(empty + 2) % 3] = n[(empty + 2) % 3] = 1.2;
    X[empty] = 7;
    n /= 1.3;

    CHECK(disc->distance(X) == near(0.8));
    CHECK(disc->distance(0.2*X) == near(-0.24));
    CHECK(disc->distance(point::zero) == near(-0.5));

    vectorField normals(3);
    disc->normal(pointField({X, 0.1*X, point::zero}), normals);

    CHECK(difference(normals[0], n) < 1e-12);
    CHECK(difference(normals[1], n) < 1e-12);
    CHECK(normals[2] == vector::zero);

    CHECK(disc->volume() == near(pi*0.25));
    CHECK(disc->boundingRadius() == near(0.5));
    CHECK(disc->width() == near(1));

    const tensor I(disc->inertia());
    const vector axis(space.emptyDir());
    CHECK(difference(I, 0.5*pi*0.0625*tensor(axis*axis)) < 1e-12);
}


TEST_CASE("Sphere: distance, normal, volume, inertia", "[shapes]")
{
    const auto sphere = shape("type sphere; radius 2;", geometricSpace(-1));
    const vector X(2, 3, 6);

    CHECK(sphere->distance(X) == near(5));
    CHECK(sphere->distance(0.1*X) == near(-1.3));
    CHECK(sphere->distance(point::zero) == near(-2));

    vectorField normals(2);
    sphere->normal(pointField({X, point::zero}), normals);

    CHECK(difference(normals[0], X/7) < 1e-12);
    CHECK(normals[1] == vector::zero);

    CHECK(sphere->volume() == near(32*pi/3));
    CHECK(sphere->boundingRadius() == near(2));
    CHECK(sphere->width() == near(4));
    CHECK(difference(tensor(sphere->inertia()), 0.4*32*pi/3*4*tensor::I)
        < 1e-10);
}


TEST_CASE("Normals are the gradient of the distance", "[shapes]")
{
    const bool twoD = GENERATE(true, false);
    const geometricSpace space(twoD ? 2 : -1);
    const auto body =
        shape(twoD ? "type disc; radius 1;" : "type sphere; radius 1;", space);

    testTools::RandomNumbers random;
    const scalar step = 1e-5;

    for (int i = 0; i < 20; ++i)
    {
        const vector X(2*random.vector());
        vectorField normal(1);
        body->normal(pointField(1, X), normal);

        vector gradient;
        for (direction k = 0; k < 3; ++k)
        {
            vector dX(Zero);
            dX[k] = step;
            gradient[k] =
                (body->distance(X + dX) - body->distance(X - dX))/(2*step);
        }

        CHECK(difference(normal[0], gradient) < 1e-6);
    }
}


TEST_CASE("Display surface of the disc", "[shapes]")
{
    const direction empty = GENERATE(0, 1, 2);
    const geometricSpace space(empty);
    const auto disc = shape("type disc; radius 0.5;", space);

    pointField points;
    faceList faces;
    disc->surface(points, faces);

    // Around the rim once: each edge between the centre and the rim belongs
    // to two faces, each rim edge to one
    EdgeMap<label> count;
    vector area(Zero);
    for (const face& f : faces)
    {
        area += f.areaNormal(points);
        for (const edge& e : f.edges())
        {
            ++count(e, 0);
        }
    }
    label rim = 0;
    forAllConstIters(count, iter)
    {
        CHECK(iter.val() <= 2);
        if (iter.val() == 1)
        {
            ++rim;
            CHECK(mag(points[iter.key().start()]) == near(0.5));
            CHECK(mag(points[iter.key().end()]) == near(0.5));
        }
    }

    const label n = faces.size();
    CHECK(rim == n);
    CHECK(n >= 24);

    // Area of the regular polygon with n corners, facing the empty direction
    const scalar polygon = 0.5*n*sqr(0.5)*Foam::sin(2*pi/n);
    CHECK(difference(area, polygon*space.emptyDir()) < 1e-12);
}


TEST_CASE("Display surface of the sphere", "[shapes]")
{
    const auto sphere = shape("type sphere; radius 2;", geometricSpace(-1));

    pointField points;
    faceList faces;
    sphere->surface(points, faces);

    for (const point& X : points)
    {
        CHECK(mag(X) == near(2));
    }

    // Closed, normals outward, nearly the volume of the sphere
    const auto result = areaAndVolume(points, faces);
    CHECK(mag(result.first) < 1e-10);
    CHECK(result.second < 32*pi/3);
    CHECK(result.second > 0.96*32*pi/3);
}


TEST_CASE("Volume and inertia are those of the points inside", "[shapes]")
{
    const size_t casei = GENERATE(range(size_t(0), shapeCases.size()));
    const shapeCase& c = shapeCases[casei];
    CAPTURE(c.text);

    const auto body = shape(c.text, c.space);
    const symmTensor I(body->inertia());

    CHECK(body->volume() == near(c.volume));
    CHECK(difference(vector(I.xx(), I.yy(), I.zz()), c.inertia) < 1e-12);
    CHECK(difference(vector(I.xy(), I.yz(), I.xz()), vector(Zero)) == 0);
    CHECK_FALSE(body->round());

    const auto sums =
        latticeSums(*body, 1.25*c.half, c.space.twoD() ? 400 : 80);
    CHECK(sums.first == Approx(c.volume).epsilon(0.01));

    for (direction k = 0; k < 3; ++k)
    {
        if (c.inertia[k] > 0)
        {
            CHECK(sums.second[k] == Approx(c.inertia[k]).epsilon(0.01));
        }
    }
}


TEST_CASE("The distance is that to the nearest surface point", "[shapes]")
{
    const size_t casei = GENERATE(range(size_t(0), shapeCases.size()));
    const shapeCase& c = shapeCases[casei];
    CAPTURE(c.text);

    const auto body = shape(c.text, c.space);
    const pointField surface(samples(*body, c));

    scalar radius = 0, largest = 0;
    for (const point& X : surface)
    {
        radius = max(radius, mag(X));
        largest = max(largest, mag(body->distance(X)));
    }
    CHECK(largest < 1e-6);
    CHECK(radius == near(body->boundingRadius()));

    testTools::RandomNumbers random;

    for (int i = 0; i < 40; ++i)
    {
        const vector X(cmptMultiply(1.7*random.vector(), c.half));
        scalar nearest = GREAT;
        for (const point& S : surface)
        {
            nearest = min(nearest, mag(X - S));
        }

        const scalar d = body->distance(X);
        CAPTURE(X);
        CHECK(mag(d) == Approx(nearest).margin(mag(d) < 0.05 ? 1e-2 : 1e-3));

        // Nearest point from the distance and its gradient
        vectorField n(1);
        body->normal(pointField(1, X), n);
        CHECK(mag(n[0]) == near(1));
        CHECK(mag(body->distance(X - d*n[0])) < 1e-10);

        vector gradient(Zero);
        for (direction k = 0; k < 3; ++k)
        {
            vector dX(Zero);
            dX[k] = 1e-6;
            gradient[k] =
                (body->distance(X + dX) - body->distance(X - dX))/2e-6;
        }
        CHECK(difference(n[0], gradient) < 1e-5);
    }
}


TEST_CASE("Display surfaces in 3D are closed, normals outward", "[shapes]")
{
    const size_t casei = GENERATE(range(size_t(0), shapeCases.size()));
    const shapeCase& c = shapeCases[casei];
    CAPTURE(c.text);

    pointField points;
    faceList faces;
    shape(c.text, c.space)->surface(points, faces);
    const auto result = areaAndVolume(points, faces);

    if (c.space.twoD())
    {
        const scalar area = result.first & c.space.emptyDir();
        CHECK(area <= c.volume*(1 + 1e-12));
        CHECK(area > 0.99*c.volume);
    }
    else
    {
        CHECK(mag(result.first) < 1e-10);
        CHECK(result.second <= c.volume*(1 + 1e-12));
        CHECK(result.second > 0.95*c.volume);
    }
}


TEST_CASE("Ellipsoid with equal axes is a sphere", "[shapes]")
{
    const geometricSpace twoD(2), threeD(-1);
    const auto ellipsoid = shape("type ellipsoid; semiAxes (2 2 2);", threeD);
    const auto sphere = shape("type sphere; radius 2;", threeD);
    const auto ellipse = shape("type ellipse; semiAxes (2 2);", twoD);
    const auto disc = shape("type disc; radius 2;", twoD);

    CHECK(ellipsoid->volume() == near(sphere->volume()));
    CHECK(difference(ellipsoid->inertia(), sphere->inertia()) < 1e-12);
    CHECK(difference(ellipse->inertia(), disc->inertia()) < 1e-12);
    CHECK(ellipsoid->distance(point::zero) == near(-2));
    CHECK(ellipse->distance(point::zero) == near(-2));

    testTools::RandomNumbers random;
    for (int i = 0; i < 20; ++i)
    {
        const point X(4*random.vector());
        CHECK(ellipsoid->distance(X) == near(sphere->distance(X)));
        CHECK(ellipse->distance(X) == near(disc->distance(X)));
    }
}


TEST_CASE("Distance of the ellipsoid on its axes and far away", "[shapes]")
{
    const auto body =
        shape("type ellipsoid; semiAxes (3 1 2);", geometricSpace(-1));

    // From the centre to the nearest vertex; on the long axis the curvature
    // at the vertex decides up to x = (9 - 1)/3
    CHECK(body->distance(point::zero) == near(-1));
    CHECK(body->distance(point(2.8, 0, 0)) == near(-0.2));
    CHECK(body->distance(point(2, 0, 0)) == near(-Foam::sqrt(0.5)));
    CHECK(body->distance(point(0, 4, 0)) == near(3));
    CHECK(body->distance(point(0, 0, -5)) == near(3));
    CHECK(body->distance(point(1e6, 0, 0)) == near(1e6 - 3));

    // Where two surface points are nearest the normal is not defined
    vectorField n(2);
    body->normal(pointField({point(2, 0, 0), point(2.8, 0, 0)}), n);
    CHECK(n[0] == vector::zero);
    CHECK(difference(n[1], vector(1, 0, 0)) < 1e-12);

    // Needle and plate: still a number, and on the right side
    const auto needle =
        shape("type ellipsoid; semiAxes (1 1e-3 1e-3);", geometricSpace(-1));
    CHECK(needle->distance(point::zero) == near(-1e-3));
    CHECK(needle->distance(point(0.5, 0, 0)) < -8e-4);
    CHECK(needle->distance(point(0.5, 0.1, 0)) == Approx(0.0991).margin(1e-4));
}


TEST_CASE("Distance of box and cylinder at faces and corners", "[shapes]")
{
    const geometricSpace threeD(-1);
    const auto box = shape("type box; size (2 4 6);", threeD);

    CHECK(box->distance(point::zero) == near(-1));
    CHECK(box->distance(point(0.2, 1.9, 0)) == near(-0.1));
    CHECK(box->distance(point(4, 0, 0)) == near(3));
    CHECK(box->distance(point(-4, 6, 0)) == near(5));
    CHECK(box->distance(point(3, -4, 4)) == near(3));
    CHECK(box->width() == near(2));
    CHECK(box->boundingRadius() == near(Foam::sqrt(14.0)));

    vectorField n(1);
    box->normal(pointField(1, point(3, -4, 4)), n);
    CHECK(difference(n[0], vector(2, -2, 1)/3) < 1e-12);
    box->normal(pointField(1, point::zero), n);
    CHECK(n[0] == vector::zero);

    const auto cylinder = shape("type cylinder; radius 1; length 4;", threeD);

    CHECK(cylinder->distance(point::zero) == near(-1));
    CHECK(cylinder->distance(point(0, 0, -1.9)) == near(-0.1));
    CHECK(cylinder->distance(point(0, -3, 1)) == near(2));
    CHECK(cylinder->distance(point(2.4, 3.2, 6)) == near(5));
    CHECK(cylinder->width() == near(2));
    cylinder->normal(pointField(1, point(2.4, 3.2, 6)), n);
    CHECK(difference(n[0], vector(0.36, 0.48, 0.8)) < 1e-12);
}


TEST_CASE("Surface of triangles: a box from a file", "[shapes]")
{
    const bool inward = GENERATE(false, true);
    const geometricSpace threeD(-1);
    const auto box = shape("type box; size (1 0.4 0.6);", threeD);

    // Away from the origin, in millimetres
    const testTools::TemporaryFolder folder;
    testTools::writeStl
    (
        folder.path()/"constant/triSurface/box.stl",
        *box, 1000, vector(1, 2, 3), inward
    );

    dictionary dict(testTools::dict("type triSurface; file \"box.stl\";"));
    dict.add("scale", 0.001);
    dict.name() = folder.path()/"constant/bodies";
    const autoPtr<bodyShape> body(bodyShape::New(dict, threeD));

    // As good as the six digits in the file
    CHECK(body->volume() == Approx(box->volume()));
    CHECK(difference(body->inertia(), box->inertia()) < 1e-6);
    CHECK(body->boundingRadius() == Approx(box->boundingRadius()));
    CHECK(body->width() == Approx(box->width()));

    const auto sums = latticeSums(*body, {0.625, 0.25, 0.375}, 40);
    CHECK(sums.first == Approx(box->volume()).epsilon(0.01));

    testTools::RandomNumbers random;

    for (int i = 0; i < 200; ++i)
    {
        const vector X(random.vector());
        CAPTURE(X);
        CHECK(body->distance(X) == Approx(box->distance(X)).margin(1e-6));

        vectorField n(1), expected(1);
        body->normal(pointField(1, X), n);
        box->normal(pointField(1, X), expected);
        CHECK(difference(n[0], expected[0]) < 1e-3);
    }

    // As the decomposed case finds it, and by its whole name
    dict.name() = folder.path()/"processor1/constant/bodies";
    CHECK(bodyShape::New(dict, threeD)->volume() == body->volume());

    dict.name() = "";
    dict.set("file", folder.path()/"constant/triSurface/box.stl");
    CHECK(bodyShape::New(dict, threeD)->volume() == body->volume());

    pointField points;
    faceList faces;
    body->surface(points, faces);
    CHECK(areaAndVolume(points, faces).second == Approx(box->volume()));

    for (const point& X : points)
    {
        CHECK(mag(body->distance(X)) < 1e-12);
    }
}


TEST_CASE("Surface of triangles: a sphere from a file", "[shapes]")
{
    const geometricSpace threeD(-1);
    const auto sphere = shape("type ellipsoid; semiAxes (1 1 1);", threeD);

    const testTools::TemporaryFolder folder;
    const fileName file(folder.path()/"sphere.stl");
    testTools::writeStl(file, *sphere, 1, vector::zero, false);
    const auto body =
        shape("type triSurface; file \"" + file + "\";", threeD);

    // Within the height of the triangles under the sphere
    CHECK(body->volume() == Approx(sphere->volume()).epsilon(0.04));
    CHECK(difference(body->inertia(), sphere->inertia()) < 0.12);

    testTools::RandomNumbers random;

    for (int i = 0; i < 100; ++i)
    {
        const vector X(2*random.vector());
        const scalar difference = body->distance(X) - sphere->distance(X);
        CAPTURE(X);
        CHECK(difference > -1e-5);
        CHECK(difference < 0.02);
    }
}


TEST_CASE("Surfaces of triangles are refused with a reason", "[shapes]")
{
    const geometricSpace twoD(2), threeD(-1);
    const auto box = shape("type box; size (1 1 1);", threeD);
    const testTools::TemporaryFolder folder;
    const fileName file(folder.path()/"box.stl");
    const std::string text("type triSurface; file \"" + file + "\";");

    auto refusal = [](const std::string& text, const geometricSpace& space)
    {
        return messageOf([&]{ shape(text, space); });
    };

    CHECK_THAT(refusal(text, threeD), Contains("There is no file"));

    testTools::writeStl(file, *box, 1, vector::zero, false);
    CHECK(refusal(text, threeD).empty());
    CHECK_THAT(refusal(text, twoD), Contains("'type triSurface'"));
    CHECK_THAT(refusal(text + "scale 0;", threeD), Contains("'scale 0'"));
    CHECK_THAT(refusal(text + "scales 1;", threeD), Contains("'scales'"));

    testTools::writeStl(file, *box, 1, vector::zero, false, 1);
    CHECK_THAT(refusal(text, threeD),
        Contains("not closed") && Contains("3 do not join"));
}


TEST_CASE("Shapes are refused with a reason", "[shapes]")
{
    const geometricSpace twoD(2), threeD(-1);

    auto refusal = [](const std::string& text, const geometricSpace& space)
    {
        return messageOf([&]{ shape(text, space); });
    };

    CHECK_THAT(refusal("type sphere; radius 1;", twoD),
        Contains("'type sphere'") && Contains("use 'disc'"));
    CHECK_THAT(refusal("type disc; radius 1;", threeD),
        Contains("'type disc'") && Contains("use 'sphere'"));
    CHECK_THAT(refusal("type disk; radius 1;", twoD),
        Contains("'type disk'") && Contains("nearest valid one is 'disc'"));
    CHECK_THAT(refusal("type disc;", twoD), Contains("radius"));
    CHECK_THAT(refusal("radius 1;", twoD), Contains("type"));
    CHECK_THAT(refusal("type disc; radius -1;", twoD),
        Contains("'radius -1'") && Contains("greater than 0"));
    CHECK_THAT(refusal("type disc; radius 1; diameter 2;", twoD),
        Contains("'diameter'"));

    CHECK_THAT(refusal("type ellipse; semiAxes (1 2);", threeD),
        Contains("use 'ellipsoid'"));
    CHECK_THAT(refusal("type ellipsoid; semiAxes (1 2 3);", twoD),
        Contains("use 'ellipse'"));
    CHECK_THAT(refusal("type ellipse; semiAxes (1 0);", twoD),
        Contains("'semiAxes'") && Contains("greater than 0"));
    CHECK_THAT(refusal("type ellipse; semiAxes (1 2); radius 1;", twoD),
        Contains("'radius'"));
    CHECK_THAT(refusal("type box; size (1 1 0);", threeD),
        Contains("'size'") && Contains("greater than 0"));
    CHECK_THAT(refusal("type box; size (1 -1 0);", twoD),
        Contains("'size'") && Contains("greater than 0"));
    CHECK_THAT(refusal("type box; sizes (1 1 1);", threeD),
        Contains("size"));
    CHECK_THAT(refusal("type cylinder; radius 1; length 1;", twoD),
        Contains("'type cylinder'") && Contains("use 'disc'"));
    CHECK_THAT(refusal("type cylinder; radius 1; length 0;", threeD),
        Contains("'length 0'") && Contains("greater than 0"));
}


TEST_CASE("Gap between bodies", "[proximity]")
{
    const geometricSpace threeD(-1);

    auto body = [&](const std::string& text, const point& position)
    {
        return immersedBody
        (
            "grain", testTools::dict("densityRatio 1;"),
            shape(text, threeD), threeD, position, 1
        );
    };

    const std::string box("type box; size (2 4 6);");
    const std::string ellipsoid("type ellipsoid; semiAxes (2 1 1);");
    const immersedBody a(body(box, {0, 0, 0}));

    // With a sphere beyond an edge, either way round
    const immersedBody sphere(body("type sphere; radius 2;", {4, 6, 0.3}));
    CHECK(proximityMonitor::gap(a, sphere) == near(3));
    CHECK(proximityMonitor::gap(sphere, a) == near(3));

    // Tip of one to a face of the other, from both sides of zero
    const immersedBody apart(body(ellipsoid, {3.25, 0.1, 0.2}));
    CHECK(proximityMonitor::gap(a, apart) == near(0.25));
    CHECK(proximityMonitor::gap(apart, a) == near(0.25));

    const immersedBody touching(body(ellipsoid, {2.75, 0.1, 0.2}));
    CHECK(proximityMonitor::gap(a, touching) == near(-0.25));

    // Within the bounding spheres of each other and yet apart
    const immersedBody above(body(box, {2.5, 0, 0}));
    CHECK(proximityMonitor::gap(a, above) == near(0.5));
}
