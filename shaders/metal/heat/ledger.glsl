// Books every joule in and out, if LEDGER is defined. Included after common.glsl.
#ifdef LEDGER
layout(std430, binding = HEAT_LEDGER) restrict buffer Ledger { vec4 ledger[]; };

/// Sum of a + b and the remainder that float cannot hold: (sum, rest), including the previous rest.
vec2 carried(vec2 sum, float added) {
    precise float change = added + sum.y;
    precise float total = sum.x + change;
    precise float taken = total - sum.x;
    precise float rest = change - taken;
    return vec2(total, rest);
}

/// `account`: a cell, or the number of cells plus a slot.
void book(int account, float gained, float lost) {
    vec4 entry = ledger[account];
    ledger[account] = vec4(carried(entry.xy, gained), carried(entry.zw, lost));
}
#else
void book(int account, float gained, float lost) {}
#endif
