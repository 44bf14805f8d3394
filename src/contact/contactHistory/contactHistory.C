// SPDX-License-Identifier: GPL-3.0-or-later

#include "contactHistory.H"

void Foam::springRecord::pack(vector* to) const
{
    to[0] = vector(bodies.first(), bodies.second(), time);
    to[1] = normal;
    to[2] = spring;
    to[3] = rolling;
    to[4] = vector(speed, gap, age);
    to[5] = slope;
}


void Foam::springRecord::unpack(const vector* from)
{
    bodies = labelPair(label(from[0].x()), label(from[0].y()));
    time = from[0].z();
    normal = from[1];
    spring = from[2];
    rolling = from[3];
    speed = from[4].x();
    gap = from[4].y();
    age = from[4].z();
    slope = from[5];
}
