// Expressions that drivers like to rearrange, in valid GLSL and C++. The includer says where the
// result PROBE(index) is; the operands a to h are positive.

// Products and sums.
PROBE(0) = a * b + a * c;
PROBE(1) = a * b + c;
PROBE(2) = a * b - c * d;
PROBE(3) = (a + b) * (c + d) - a * c;
PROBE(4) = a + b + c + d + e + f + g + h;
PROBE(5) = (a + b) - a;
PROBE(6) = a * 0.3f + b * 0.3f + c * 0.3f;
PROBE(7) = a * b * c * d * e * f;
// Quotients and roots.
PROBE(8) = 1.0f / (a + b + c);
PROBE(9) = a / b / c;
PROBE(10) = a * b / c + d * b / c;
PROBE(11) = sqrt(a) * sqrt(b) + sqrt(a * c);
PROBE(12) = 1.0f / sqrt(a + b);
// What methods are made of.
PROBE(13) = a + (1.0f - b) * (c + (1.0f - d) * (e + (1.0f - f) * g));
PROBE(14) = (1.0f - a) * (1.0f - b) * (1.0f - c) * (1.0f - d);
PROBE(15) = floor((a + b) * 16.0f + c * 16.0f) - max(a * b, min(c, d));
PROBE(16) = moment_roots(a, b, c, d, 0.01f);
