// Gathers the entries that a work group has to work on. Included after common.glsl and the group size.
shared uint chosen[GROUP_SIZE];
shared uint chosenCount;

/// Gives the wanted entries of a group to its first invocations, in no order: the others have nothing to do and cost
/// nothing. Every invocation of the group must call it. False where there is no entry for this one.
bool choose(bool wanted, inout uint entry) {
    if (gl_LocalInvocationIndex == 0) chosenCount = 0;
    barrier();
    if (wanted) chosen[atomicAdd(chosenCount, 1u)] = entry;
    barrier();
    if (gl_LocalInvocationIndex >= chosenCount) return false;
    entry = chosen[gl_LocalInvocationIndex];
    return true;
}
