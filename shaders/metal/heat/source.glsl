// How much of a heat source a place on the metal sees. Included after heat_common.glsl.

/// Share of source `s` that goes to metal at `place` with the given volume (m³), free surface (outward unit normal, area in
/// m²) and temperature (K), before normalisation. The tip's weight is in W.
float sourceWeight(HeatSourceData s, vec3 place, float volume, vec4 surface, float temperature) {
    vec3 d = place - s.place.xyz;
    float size = s.ahead.w;
    int kind = int(s.place.w);
    if (kind == SOURCE_SPHERE) return volume * max(0.0, 1.0 - dot(d, d) / (size * size));
    float depth = dot(d, s.axis.xyz);
    if (kind == SOURCE_GAUSSIAN) {
        float r2 = max(0.0, dot(d, d) - depth * depth);
        return surface.w * max(0.0, -dot(surface.xyz, s.axis.xyz)) * exp(-r2 / (2.0 * size * size));
    }
    if (kind == SOURCE_TIP) {
        float reach = dot(d, d) <= size * size ? surface.w : 0.0;
        return reach * s.shape.y * max(0.0, s.shape.x - temperature);
    }
    float ahead = dot(d, s.ahead.xyz);
    float across = dot(d, cross(s.ahead.xyz, s.axis.xyz));
    bool front = ahead >= 0.0;
    float length2 = front ? size : s.shape.z;
    // Half-axes differ in front and rear, and so does the peak: fraction over length.
    float peak = (front ? s.shape.w : 2.0 - s.shape.w) / length2;
    vec3 q = vec3(ahead / length2, across / s.shape.x, depth / s.shape.y);
    return volume * peak * exp(-3.0 * dot(q, q));
}

/// Watts a unit of weight is worth, from the sum of all weights.
float sourceScale(HeatSourceData s, float total) {
    if (total <= 0.0) return 0.0;
    float scale = s.axis.w / total;
    return int(s.place.w) == SOURCE_TIP ? min(1.0, scale) : scale;
}

/// Tile number `group` of the box that the source reaches.
ivec3 sourceTile(HeatSourceData s, int group) {
    return s.lowTile.xyz +
           ivec3(group % s.tileCount.x, group / s.tileCount.x % s.tileCount.y, group / (s.tileCount.x * s.tileCount.y));
}

/// Number of a tile in the box that the source reaches.
int sourcePlace(HeatSourceData s, ivec3 tilePlace) {
    ivec3 at = tilePlace - s.lowTile.xyz;
    return (at.z * s.tileCount.y + at.y) * s.tileCount.x + at.x;
}

/// Temperature that belongs to a Kirchhoff variable, by halving the table.
float temperatureOf(float theta) {
    int low = 0;
    int high = HEAT_TABLE_ENTRIES - 1;
    while (high - low > 1) {
        int middle = (low + high) / 2;
        if (texelFetch(table, middle).y <= theta)
            low = middle;
        else
            high = middle;
    }
    vec2 a = texelFetch(table, low).xy;
    vec2 b = texelFetch(table, high).xy;
    return b.y > a.y ? mix(a.x, b.x, (theta - a.y) / (b.y - a.y)) : a.x;
}

/// Weight of cell `inside` of a tile for source `s`, from how full it is, its free surface and its Kirchhoff variable.
float cellWeightIn(HeatSourceData s, ivec3 tilePlace, int inside, float weight, vec4 surface, float theta) {
    float volume = weight * metal.spacing * metal.spacing * metal.spacing;
    vec3 place = cellCentre(tilePlace * TILE_EDGE + insideCoordinate(inside));
    float temperature = int(s.place.w) == SOURCE_TIP ? temperatureOf(theta) : 0.0;
    return sourceWeight(s, place, volume, surface, temperature);
}
