// The longest chain of arithmetic among the methods: two roots from four power moments, by an LDL^T
// decomposition. Peters and Klein. Moment Shadow Mapping. I3D 2015. Valid GLSL and C++.

// Of equal masses at depths p, q and r, seen from depth z; `bias` keeps the matrix regular.
float moment_roots(float p, float q, float r, float z, float bias)
{
    float third = 0.33333334f;
    float b1 = (1.0f - bias) * ((p + q + r) * third);
    float b2 = (1.0f - bias) * ((p * p + q * q + r * r) * third) + bias * 0.375f;
    float b3 = (1.0f - bias) * ((p * p * p + q * q * q + r * r * r) * third);
    float b4 =
        (1.0f - bias) * ((p * p * p * p + q * q * q * q + r * r * r * r) * third) + bias * 0.375f;

    float l32_d22 = b3 - b1 * b2;
    float d22 = b2 - b1 * b1;
    float variance = b4 - b2 * b2;
    float d33_d22 = variance * d22 - l32_d22 * l32_d22;
    float l32 = l32_d22 / d22;

    float c2 = z - b1;
    float c3 = z * z - b2 - l32 * c2;
    c2 = c2 / d22;
    c3 = c3 * (d22 / d33_d22);
    c2 = c2 - l32 * c3;
    float c1 = 1.0f - c2 * b1 - c3 * b2;

    float half_sum = c2 / c3 * 0.5f;
    float root = sqrt(max(half_sum * half_sum - c1 / c3, 0.0f));
    return (root - half_sum) * (root + half_sum);
}
