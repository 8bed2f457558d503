// Prefix sum of one flag a thread within a group of PIECES_GROUP threads, for passes that run as a single group.
shared uint scanned[PIECES_GROUP];

/// Number of threads before this one whose flag is set; `total` becomes that of the whole group.
uint countBefore(bool flag, out uint total) {
    uint lane = gl_LocalInvocationID.x;
    scanned[lane] = flag ? 1 : 0;
    barrier();
    for (uint reach = 1; reach < PIECES_GROUP; reach *= 2) {
        uint sum = scanned[lane] + (lane >= reach ? scanned[lane - reach] : 0);
        barrier();
        scanned[lane] = sum;
        barrier();
    }
    total = scanned[PIECES_GROUP - 1];
    uint before = scanned[lane] - (flag ? 1 : 0);
    barrier();
    return before;
}
