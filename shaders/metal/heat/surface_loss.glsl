// Losses of a free surface: convection, radiation and, if the material has the data, evaporation. Included after
// common.glsl.

/// Power (W) that `area` (m²) at `temperature` (K) loses to the air and by radiation.
float surfaceLoss(float temperature, float area) {
    float ambient = heatBlock.ambient;
    float t2 = temperature * temperature;
    float a2 = ambient * ambient;
    return area * (heatBlock.convection * (temperature - ambient) + heatBlock.radiation * (t2 * t2 - a2 * a2));
}

/// Power (W/m²) lost by evaporation at `temperature`, after Hertz (1882), Knudsen (1915) and Langmuir (1913), with the
/// vapour pressure of Clausius and Clapeyron.
float evaporationFlux(float temperature) {
    float exponent = heatBlock.evaporationExponent * (1.0 / heatBlock.boilingPoint - 1.0 / temperature);
    return heatBlock.evaporationFactor * inversesqrt(temperature) * exp(exponent);
}

/// True if metal is so hot that its evaporation counts.
bool evaporates(float temperature) { return temperature > heatBlock.evaporatesFrom; }

/// Temperature after a step in which a surface that would have reached `hot` also evaporates. The flux rises so steeply
/// that it is taken at the end of the step: Newton's method for T + area dt q(T)/(m c) = hot, which converges from
/// above.
float afterEvaporation(float hot, float area) {
    float cooling = area * heatBlock.timeStep / (metal.particleMass * heatBlock.liquidSpecificHeat);
    float t = hot;
    bool boils = area > 0.0 && evaporates(hot);
    for (int i = 0; i < heatBlock.mostTurns && boils; ++i) {
        float flux = evaporationFlux(t);
        float change = (t + cooling * flux - hot) / (1.0 + cooling * flux * heatBlock.evaporationExponent / (t * t));
        t -= change;
        boils = abs(change) > 0.01;
    }
    return area > 0.0 ? max(t, min(hot, heatBlock.evaporatesFrom)) : hot;
}

/// Energy (J) that a particle of the given enthalpy and temperature with `area` of free surface loses in this step, in
/// which it takes up `joules` otherwise. Loss to the air may be due for a longer time than the step.
float particleLoss(float enthalpy, float temperature, float joules, float area, float due) {
    float lost = surfaceLoss(temperature, area) * due;
#ifdef EVAPORATION
    float hot = thermalState(enthalpy + (joules - lost) / metal.particleMass).x;
    lost += (hot - afterEvaporation(hot, area)) * heatBlock.liquidSpecificHeat * metal.particleMass;
#endif
    return lost;
}
