// Prefix sum of one number a thread within a group of FRAGMENT_GROUP threads, for passes that run as a single group:
// each thread sums a run of slots, so that the group synchronises only a few times for any number of slots.
shared uint scanned[FRAGMENT_GROUP];

/// First slot of this thread's run; the run ends where the next thread's begins.
uint runStart(uint lane) {
    uint length = (counters.particles + FRAGMENT_GROUP - 1) / FRAGMENT_GROUP;
    return min(lane * length, counters.particles);
}

/// Sum of the numbers of the threads before this one; `total` becomes that of the whole group.
uint sumBefore(uint number, out uint total) {
    uint lane = gl_LocalInvocationID.x;
    scanned[lane] = number;
    barrier();
    for (uint reach = 1; reach < FRAGMENT_GROUP; reach *= 2) {
        uint sum = scanned[lane] + (lane >= reach ? scanned[lane - reach] : 0);
        barrier();
        scanned[lane] = sum;
        barrier();
    }
    total = scanned[FRAGMENT_GROUP - 1];
    return scanned[lane] - number;
}
