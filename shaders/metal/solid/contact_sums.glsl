// Contacts of a particle of a free fragment: fixed metal, floor and walls, other free fragments. Penalty contacts after
// the discrete element method of Cundall and Strack (1979). Included after common.glsl.

// A spring that turns an overlap around in a few steps, and its damper: stable for a lone particle with five neighbours.
const float kImpactSpring = 0.2;
const float kImpactDamper = 0.2;

/// Adds a contact with a particle that is `displacement` (m) away and moves with `relativeVelocity` (m/s), fixed or free.
void addContact(vec3 displacement, vec3 relativeVelocity, bool fixed_, inout FragmentContact sum) {
    float reach = metal.spacing;
    float distance = length(displacement);
    if (distance >= reach || distance < 1e-3 * reach) return;
    vec3 normal = displacement / distance;
    float overlap = reach - distance;
    float approach = dot(relativeVelocity, normal);
    if (fixed_) {
        sum.overlap += ivec3(round(overlap * normal * 1e9));
        ++sum.fixedContacts;
        sum.normalVelocity += ivec3(round(approach * normal * 1e6));
        sum.slipVelocity += ivec3(round((relativeVelocity - approach * normal) * 1e6));
    } else {
        float dt = fragmentBlock.timeStep;
        vec3 acceleration = (kImpactSpring * overlap / dt - kImpactDamper * approach) / dt * normal;
        sum.impact += ivec3(round(clamp(acceleration, -1e5, 1e5) * 1e3));
    }
}

void addLatticeContacts(vec3 place, vec3 own, inout FragmentContact sum) {
    ivec3 centre = latticeCell(place);
    for (int z = -1; z <= 1; ++z)
        for (int y = -1; y <= 1; ++y)
            for (int x = -1; x <= 1; ++x) {
                ivec3 cell = centre + ivec3(x, y, z);
                if (!inLattice(cell)) continue;
                uint other = latticeSlot[latticeIndex(cell)];
                if (other != 0 && isSolid(phase[other - 1])) addContact(place - position[other - 1].xyz, own, true, sum);
            }
}

void addFixedContacts(uint cell, vec3 place, vec3 own, inout FragmentContact sum) {
    for (uint other = head[fixedList(cell)]; other != 0; other = next[other - 1])
        addContact(place - position[other - 1].xyz, own, true, sum);
}

void addFreeContacts(uint cell, vec3 place, vec3 own, uint fragment, inout FragmentContact sum) {
    for (uint other = head[freeList(cell)]; other != 0; other = next[other - 1])
        if (fragmentOf(phase[other - 1]) != fragment)
            addContact(place - position[other - 1].xyz, own - velocity[other - 1].xyz, false, sum);
}

void addOffLatticeContacts(vec3 place, vec3 own, uint fragment, inout FragmentContact sum) {
    ivec3 centre = coarseCell(place);
    ivec3 low = max(centre - 1, ivec3(0));
    ivec3 high = min(centre + 1, fragmentBlock.coarseCells - 1);
    for (int z = low.z; z <= high.z; ++z)
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x) {
                uint cell = coarseIndex(ivec3(x, y, z));
                addFixedContacts(cell, place, own, sum);
                addFreeContacts(cell, place, own, fragment, sum);
            }
}

/// Adds the contact with a plane that the centre is `height` (m) in front of: the particle's rim touches it, half a spacing
/// from its centre.
void addPlaneContact(float height, vec3 normal, vec3 own, inout FragmentContact sum) {
    addContact(max(height + 0.5 * metal.spacing, 0.01 * metal.spacing) * normal, own, true, sum);
}

void addWallContacts(vec3 place, vec3 own, inout FragmentContact sum) {
    vec3 low = place - fragmentBlock.low, high = fragmentBlock.high - place;
    addPlaneContact(low.x, vec3(1, 0, 0), own, sum);
    addPlaneContact(high.x, vec3(-1, 0, 0), own, sum);
    addPlaneContact(low.z, vec3(0, 0, 1), own, sum);
    addPlaneContact(high.z, vec3(0, 0, -1), own, sum);
}

FragmentContact noContact() { return FragmentContact(ivec3(0), 0, ivec3(0), 0, ivec3(0), 0, ivec3(0), 0); }

/// True if a particle at `place` would touch fixed metal.
bool touchesFixed(vec3 place) {
    FragmentContact sum = noContact();
    addLatticeContacts(place, vec3(0), sum);
    ivec3 centre = coarseCell(place);
    ivec3 low = max(centre - 1, ivec3(0));
    ivec3 high = min(centre + 1, fragmentBlock.coarseCells - 1);
    for (int z = low.z; z <= high.z; ++z)
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x) addFixedContacts(coarseIndex(ivec3(x, y, z)), place, vec3(0), sum);
    return sum.fixedContacts != 0;
}

/// Longest way in a step, in spacings, without a check: the particle cannot pass metal that it touches.
const float kSlowWay = 0.3;
/// Spacings between the checked places of a longer way, unless those would be more than kMostPieces.
const float kPiece = 0.2;
const float kMostPieces = 16;

/// True inside the face of solid metal of the lattice.
bool insideLattice(vec3 place) {
    ivec3 cell = latticeCell(place);
    if (!inLattice(cell)) return false;
    uint filled = latticeSlot[latticeIndex(cell)];
    return filled != 0 && isSolid(phase[filled - 1]);
}

/// Share of a long way until a particle touches fixed metal; the contact stops it in the steps that follow. A particle
/// in contact already goes on by one piece.
float shareUntilTouch(vec3 place, vec3 way, FragmentContact touched) {
    float pieces = min(ceil(length(way) / (kPiece * metal.spacing)), kMostPieces);
    if (touched.fixedContacts != 0 && dot(vec3(touched.overlap), vec3(touched.normalVelocity)) < 0) return 1.0 / pieces;
    for (float piece = 1; piece < pieces; ++piece)
        if (touchesFixed(place + way * (piece / pieces))) return piece / pieces;
    return 1.0;
}

/// Share of its way in this step that a particle may go. A lone one would squeeze through the faces of a lattice, whose
/// particles push it aside more than back: none goes behind such a face.
float freeShare(vec3 place, vec3 own, FragmentContact touched) {
    vec3 way = own * fragmentBlock.timeStep;
    float share = length(way) > kSlowWay * metal.spacing ? shareUntilTouch(place, way, touched) : 1.0;
    return insideLattice(place + way * share) && !insideLattice(place) ? 0.0 : share;
}

/// Sums over the contacts of the particle in `slot`; zero once it melted.
FragmentContact contactsOf(uint slot) {
    FragmentContact sum = noContact();
    uint bits = phase[slot];
    if (!isSolid(bits)) return sum;
    vec3 place = position[slot].xyz;
    vec3 own = velocity[slot].xyz;
    addLatticeContacts(place, own, sum);
    addOffLatticeContacts(place, own, fragmentOf(bits), sum);
    addPlaneContact(dot(place, fragmentBlock.floorNormal) - fragmentBlock.floorHeight, fragmentBlock.floorNormal, own, sum);
    addWallContacts(place, own, sum);
    return sum;
}
