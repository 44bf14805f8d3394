// SPDX-License-Identifier: GPL-3.0-or-later

#include "placedBodies.H"
#include <algorithm>
#include <cctype>

const Foam::placedBodies::entry& Foam::placedBodies::entryOf
(
    const label number
) const
{
    // The last one that does not begin behind it; none of them is empty
    const auto after = std::upper_bound
    (
        entries_.begin(), entries_.end(), number,
        [](const label n, const entry& e) { return n < e.first; }
    );

    return *(after - 1);
}


const Foam::point& Foam::placedBodies::position(const label number) const
{
    const entry& e = entryOf(number);

    return e.positions[number - e.first];
}


Foam::word Foam::placedBodies::entry::nameOf(const label i) const
{
    return single ? name : word(name + Foam::name(i + 1), false);
}


Foam::label Foam::placedBodies::entry::find(const word& body) const
{
    const label n = name.size();
    label i = 0;

    if (single)
    {
        return body == name ? first : -1;
    }

    // No zeros in front
    const bool numbered =
        body.compare(0, n, name) == 0
     && Foam::read(body.substr(n), i)
     && i >= 1 && i <= positions.size()
     && nameOf(i - 1) == body;

    return numbered ? first + i - 1 : -1;
}


Foam::word Foam::placedBodies::name(const label number) const
{
    const entry& e = entryOf(number);

    return e.nameOf(number - e.first);
}


Foam::DynamicList<Foam::label> Foam::placedBodies::before
(
    const word& name
) const
{
    DynamicList<label> found;

    for (auto n = name.size(); n > 1 && std::isdigit(name[n - 1]); --n)
    {
        const auto iter = places_.cfind(word(name.substr(0, n - 1), false));

        if (iter.found())
        {
            found.append(iter());
        }
    }

    return found;
}


Foam::label Foam::placedBodies::find(const word& name) const
{
    const auto iter = places_.cfind(name);

    if (iter.found() && entries_[iter()].single)
    {
        return entries_[iter()].first;
    }

    for (const label i : before(name))
    {
        const label number = entries_[i].find(name);

        if (number >= 0)
        {
            return number;
        }
    }

    return -1;
}


Foam::autoPtr<Foam::immersedBody> Foam::placedBodies::make
(
    const label number
) const
{
    const entry& e = entryOf(number);
    const label i = number - e.first;

    autoPtr<immersedBody> body
    (
        new immersedBody
        (
            name(number), e.kind, e.positions[i],
            e.orientations[min(i, e.orientations.size() - 1)]
        )
    );

    body->setNumber(number);

    return body;
}


void Foam::placedBodies::append(entry&& e)
{
    if (e.positions.empty())
    {
        return;
    }

    e.first = size_;
    size_ += e.positions.size();
    places_.insert(e.name, entries_.size());
    entries_.push_back(std::move(e));
}
