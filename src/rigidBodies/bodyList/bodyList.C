// SPDX-License-Identifier: GPL-3.0-or-later

#include "bodyList.H"
#include "bodyShare.H"
#include "ListOps.H"
#include <algorithm>

Foam::bodyList::dependent::dependent(bodyList& bodies)
:
    bodies_(bodies)
{
    bodies_.dependents_.append(this);
}


Foam::bodyList::dependent::~dependent()
{
    DynamicList<dependent*> others(bodies_.dependents_.size());

    for (dependent* other : bodies_.dependents_)
    {
        if (other != this)
        {
            others.append(other);
        }
    }
    bodies_.dependents_.transfer(others);
}


Foam::bodyList::bodyList
(
    PtrList<immersedBody>&& bodies,
    const label nSpread
)
{
    forAll(bodies, i)
    {
        PtrDynList<immersedBody>::append(bodies.release(i).ptr());
    }
    share_.reset(new bodyShare(*this, nSpread));
}


Foam::bodyList::~bodyList()
{}


template<class Condition>
bool Foam::bodyList::any(const Condition& condition) const
{
    bool found = false;

    for (const immersedBody& body : *this)
    {
        found = found || condition(body);
    }

    return share_->any(found);
}


bool Foam::bodyList::anyResolved() const
{
    return any([](const immersedBody& body) { return body.resolved(); });
}


bool Foam::bodyList::anyFree() const
{
    return any
    (
        [](const immersedBody& body)
        {
            return body.resolved() && body.isFree();
        }
    );
}


bool Foam::bodyList::anyInContact() const
{
    return any
    (
        [](const immersedBody& body)
        {
            return body.resolved() && body.contact().any();
        }
    );
}


bool Foam::bodyList::atRest() const
{
    return !any([](const immersedBody& body) { return !body.isFixed(); });
}


Foam::label Foam::bodyList::nAsleep() const
{
    return share_->sum<label>
    (
        [&](const label i) { return operator[](i).status().asleep(); }
    );
}


Foam::label Foam::bodyList::nUnresolved() const
{
    label n = 0;

    for (const immersedBody& body : *this)
    {
        n += !body.resolved();
    }

    return n;
}


Foam::scalar Foam::bodyList::maxSpeed() const
{
    scalar speed = 0;

    for (const immersedBody& body : *this)
    {
        speed = max(speed, body.maxSpeed());
    }

    return share_->largest(speed);
}


Foam::scalar Foam::bodyList::contactSpeed() const
{
    scalar speed = 0;

    for (const immersedBody& body : *this)
    {
        speed = max
        (
            speed, body.contact().speed(body.shape().boundingRadius())
        );
    }

    return share_->largest(speed);
}


void Foam::bodyList::append(autoPtr<immersedBody>&& body)
{
    PtrDynList<immersedBody>::append(body.ptr());

    for (dependent* one : dependents_)
    {
        one->added();
    }
}


void Foam::bodyList::append
(
    autoPtr<immersedBody>&& body,
    const UList<char>& packed
)
{
    append(std::move(body));

    const char* data = packed.cdata();

    for (dependent* one : dependents_)
    {
        one->unpack(size() - 1, data);
    }
}


Foam::List<char> Foam::bodyList::pack(const label i) const
{
    DynamicList<char> data;

    for (const dependent* one : dependents_)
    {
        one->pack(i, data);
    }

    return List<char>(std::move(data));
}


Foam::autoPtr<Foam::immersedBody> Foam::bodyList::take(const label i)
{
    typedef PtrDynList<immersedBody> list;

    autoPtr<immersedBody> body(list::release(i));

    for (label j = i + 1; j < size(); ++j)
    {
        set(j - 1, list::release(j));
    }
    list::resize(size() - 1);

    for (dependent* one : dependents_)
    {
        one->removed(i);
    }

    return body;
}


void Foam::bodyList::reorder(const labelUList& order)
{
    typedef PtrDynList<immersedBody> list;

    PtrList<immersedBody> kept(order.size());

    forAll(order, i)
    {
        kept.set(i, list::release(order[i]));
    }

    list::clear();
    forAll(kept, i)
    {
        list::append(kept.release(i).ptr());
    }
    list::shrink();

    for (dependent* one : dependents_)
    {
        one->reordered(order);
    }
}


void Foam::bodyList::sort()
{
    labelList order(identity(size()));

    std::sort
    (
        order.begin(), order.end(),
        [&](const label i, const label j)
        {
            return operator[](i).number() < operator[](j).number();
        }
    );
    reorder(order);
}
