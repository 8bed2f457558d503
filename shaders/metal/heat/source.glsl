// Share of a heat source that a place on the metal sees. Included after free_surface.glsl.

/// Slope against the source's axis up to which a surface blocks no heat from itself: 63 degrees.
const float kSteepestSurface = 2.0;

/// 1 on the heated stretch of a Gaussian's axis, 0 off it; the ends are a spacing wide. Metal before that stretch is
/// behind the torch, metal beyond it in the shadow of the surface that the axis meets first. That surface may slope.
float shareInFront(HeatSourceData s, float depth, float off) {
    float before = (depth + s.before) / metal.spacing;
    float beyond = (s.beyond + kSteepestSurface * off - depth) / metal.spacing;
    return clamp(before + 0.5, 0.0, 1.0) * clamp(beyond + 0.5, 0.0, 1.0);
}

/// Share of source `s` that goes to metal at `place` with the given volume (m³), free surface and temperature
/// (K), before normalisation. The tip's weight is in W.
float sourceWeight(HeatSourceData s, vec3 place, float volume, FreeSurface surface, float temperature) {
    vec3 d = place - s.position;
    float size = s.size;
    int kind = s.kind;
    if (kind == SOURCE_SPHERE) return volume * max(0.0, 1.0 - dot(d, d) / (size * size));
    float depth = dot(d, s.axis);
    if (kind == SOURCE_GAUSSIAN) {
        float r2 = max(0.0, dot(d, d) - depth * depth);
        return surface.area * max(0.0, -dot(surface.normal, s.axis)) * exp(-r2 / (2.0 * size * size)) *
               shareInFront(s, depth, sqrt(r2));
    }
    if (kind == SOURCE_TIP) {
        float reach = dot(d, d) <= size * size ? surface.area : 0.0;
        return reach * s.tipConductance * max(0.0, s.tipTemperature - temperature);
    }
    float ahead = dot(d, s.travel);
    float across = dot(d, cross(s.travel, s.axis));
    bool front = ahead >= 0.0;
    float length2 = front ? size : s.rear;
    // Half-axes differ in front and rear, and so does the peak: fraction over length.
    float peak = (front ? s.frontFraction : 2.0 - s.frontFraction) / length2;
    vec3 q = vec3(ahead / length2, across / s.halfWidth, depth / s.depth);
    return volume * peak * exp(-3.0 * dot(q, q));
}

/// Watts per unit of weight, from the sum of all weights. Power that misses the metal heats nothing.
float sourceScale(HeatSourceData s, float total) {
    if (total <= 0.0) return 0.0;
    float scale = s.power / max(total, s.fullWeight);
    return s.kind == SOURCE_TIP ? min(1.0, scale) : scale;
}

/// Temperature of a Kirchhoff variable, by bisection of the table.
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

/// Weight of cell `inside` of a tile for source `s`, from its fullness, its free surface and its Kirchhoff variable.
float cellWeightIn(HeatSourceData s, ivec3 tilePlace, int inside, float weight, FreeSurface surface, float theta) {
    float volume = weight * metal.spacing * metal.spacing * metal.spacing;
    vec3 place = cellCentre(tilePlace * TILE_EDGE + insideCoordinate(inside));
    float temperature = s.kind == SOURCE_TIP ? temperatureOf(theta) : 0.0;
    return sourceWeight(s, place, volume, surface, temperature);
}
