// SPDX-License-Identifier: GPL-3.0-or-later

#include "unitSurfaces.H"
#include "DynamicList.H"
#include "mathematicalConstants.H"

using Foam::constant::mathematical::pi;
using Foam::constant::mathematical::twoPi;

void Foam::unitSurfaces::disc
(
    const vector& emptyDir,
    pointField& points,
    faceList& faces
)
{
    const label nSectors = 48;

    // Two unit vectors in the plane, right-handed with its normal
    const vector e1(emptyDir.y(), emptyDir.z(), emptyDir.x());
    const vector e2(emptyDir^e1);

    points.setSize(nSectors + 1);
    faces.setSize(nSectors);
    points[nSectors] = Zero;

    for (label i = 0; i < nSectors; ++i)
    {
        const scalar angle = twoPi*i/nSectors;
        points[i] = Foam::cos(angle)*e1 + Foam::sin(angle)*e2;
        faces[i] = face(labelList({nSectors, i, (i + 1) % nSectors}));
    }
}


void Foam::unitSurfaces::revolution
(
    const vector2DField& profile,
    pointField& points,
    faceList& faces
)
{
    const label nAround = 24;
    const label nAlong = profile.size() - 1;

    points.setSize(nAround*(nAlong + 1));
    faces.setSize(nAround*nAlong);

    for (label j = 0; j <= nAlong; ++j)
    {
        for (label i = 0; i < nAround; ++i)
        {
            const scalar angle = twoPi*i/nAround;
            const label next = (i + 1) % nAround;

            points[j*nAround + i] = vector
            (
                profile[j].x()*Foam::cos(angle),
                profile[j].x()*Foam::sin(angle),
                profile[j].y()
            );

            if (j < nAlong)
            {
                const label here = j*nAround, below = here + nAround;

                faces[here + i] = face
                (
                    labelList({here + i, below + i, below + next, here + next})
                );
            }
        }
    }
}


void Foam::unitSurfaces::sphere(pointField& points, faceList& faces)
{
    const label nAlong = 12;
    vector2DField profile(nAlong + 1);

    forAll(profile, j)
    {
        const scalar theta = pi*j/nAlong;
        profile[j] = vector2D(Foam::sin(theta), Foam::cos(theta));
    }

    revolution(profile, points, faces);
}


void Foam::unitSurfaces::box
(
    const vector& emptyDir,
    pointField& points,
    faceList& faces
)
{
    const label n = 8;

    DynamicList<point> X;
    DynamicList<face> f;

    for (label side = 0; side < 6; ++side)
    {
        // Unit vectors along the face, right-handed with its normal
        vector normal(Zero);
        normal[side/2] = 1;
        const vector e1(normal.z(), normal.x(), normal.y());
        const vector e2(normal^e1);

        // In 2D one side is moved into the plane
        const bool twoD = emptyDir != vector::zero;
        const vector centre(twoD ? vector(Zero) : side % 2 ? -normal : normal);

        if (twoD && (side % 2 || normal != emptyDir))
        {
            continue;
        }

        const label start = X.size();

        for (label j = 0; j <= n; ++j)
        {
            for (label i = 0; i <= n; ++i)
            {
                X.append(centre + (2.0*i/n - 1)*e1 + (2.0*j/n - 1)*e2);

                if (i < n && j < n)
                {
                    const label a = start + j*(n + 1) + i, b = a + n + 1;
                    const face square(labelList({a, a + 1, b + 1, b}));

                    f.append(side % 2 ? square.reverseFace() : square);
                }
            }
        }
    }

    points.transfer(X);
    faces.transfer(f);
}
