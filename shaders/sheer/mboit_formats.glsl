// What six and eight power moments become as numbers of 16 bits from 0 to 1, and back.
// Muenstermann, Krumpen, Klein and Peters. Moment-Based Order-Independent Transparency. I3D 2018,
// supplement: turned by linear maps so that of any single depth each number takes all of its range.
// Of a symmetric measure the odd moments are 0, so odd and even ones are turned apart.
// Needs prelude.glsl, exponential.glsl, moment.glsl, moment_formats.glsl.

// Three or four of them.
struct RoundedNumbers {
    real n[4];
};

// Rows are those of the paper's matrices, or of its matrices' transposes where it has numbers from
// the left.
SHEER_FN RoundedNumbers six_odd(RoundedNumbers x)
{
    RoundedNumbers y = x;
    y.n[0] = real(2.5f) * x.n[0] + real(-10.0f) * x.n[1] + real(8.0f) * x.n[2];
    y.n[1] = real(-1.87499864f) * x.n[0] + real(4.20757543f) * x.n[1] + real(-1.83257679f) * x.n[2];
    y.n[2] = real(1.26583039f) * x.n[0] + real(-1.47644883f) * x.n[1] + real(0.710616602f) * x.n[2];
    return y;
}

SHEER_FN RoundedNumbers six_odd_back(RoundedNumbers x)
{
    RoundedNumbers y = x;
    y.n[0] =
        real(-0.0287778919f) * x.n[0] + real(0.476355504f) * x.n[1] + real(1.55242809f) * x.n[2];
    y.n[1] =
        real(0.0999523571f) * x.n[0] + real(0.845325809f) * x.n[1] + real(1.05472571f) * x.n[2];
    y.n[2] =
        real(0.258933538f) * x.n[0] + real(0.907796167f) * x.n[1] + real(0.833273356f) * x.n[2];
    return y;
}

SHEER_FN RoundedNumbers six_even(RoundedNumbers x)
{
    RoundedNumbers y = x;
    y.n[0] = real(4.0f) * x.n[0] + real(-4.0f) * x.n[1];
    y.n[1] = real(9.0f) * x.n[0] + real(-24.0f) * x.n[1] + real(16.0f) * x.n[2];
    y.n[2] =
        real(-0.577598065f) * x.n[0] + real(4.61936648f) * x.n[1] + real(-3.07953907f) * x.n[2];
    return y;
}

SHEER_FN RoundedNumbers six_even_back(RoundedNumbers x)
{
    RoundedNumbers y = x;
    y.n[0] =
        real(1.253044e-05f) * x.n[0] + real(0.166684942f) * x.n[1] + real(0.866025406f) * x.n[2];
    y.n[1] =
        real(-0.24998747f) * x.n[0] + real(0.166684942f) * x.n[1] + real(0.866025406f) * x.n[2];
    y.n[2] =
        real(-0.374988253f) * x.n[0] + real(0.218767133f) * x.n[1] + real(0.811898818f) * x.n[2];
    return y;
}

SHEER_FN RoundedNumbers eight_odd(RoundedNumbers x)
{
    RoundedNumbers y = x;
    y.n[0] = real(3.48044636f) * x.n[0] + real(-27.5760738f) * x.n[1] + real(55.1267384f) * x.n[2] +
             real(-31.531111f) * x.n[3];
    y.n[1] = real(1.26797186f) * x.n[0] + real(-0.928755809f) * x.n[1] +
             real(-2.07520453f) * x.n[2] + real(1.23598848f) * x.n[3];
    y.n[2] = real(-2.167156f) * x.n[0] + real(6.179502f) * x.n[1] + real(-0.276515572f) * x.n[2] +
             real(-4.23583042f) * x.n[3];
    y.n[3] = real(0.974332879f) * x.n[0] + real(-0.443426831f) * x.n[1] +
             real(-0.360491648f) * x.n[2] + real(0.310149466f) * x.n[3];
    return y;
}

SHEER_FN RoundedNumbers eight_odd_back(RoundedNumbers x)
{
    RoundedNumbers y = x;
    y.n[0] = real(-0.00482399709f) * x.n[0] + real(-0.423201509f) * x.n[1] +
             real(0.0348312383f) * x.n[2] + real(1.67179208f) * x.n[3];
    y.n[1] = real(-0.0233402219f) * x.n[0] + real(-0.832829097f) * x.n[1] +
             real(0.019340604f) * x.n[2] + real(1.21021509f) * x.n[3];
    y.n[2] = real(-0.010888537f) * x.n[0] + real(-0.926393773f) * x.n[1] +
             real(-0.117233944f) * x.n[2] + real(0.983723302f) * x.n[3];
    y.n[3] = real(-0.0308713358f) * x.n[0] + real(-0.937989173f) * x.n[1] +
             real(-0.218033378f) * x.n[2] + real(0.845991731f) * x.n[3];
    return y;
}

SHEER_FN RoundedNumbers eight_even(RoundedNumbers x)
{
    RoundedNumbers y = x;
    y.n[0] = real(0.280504133f) * x.n[0] + real(-0.757633845f) * x.n[1] +
             real(0.392179589f) * x.n[2] + real(-0.887531872f) * x.n[3];
    y.n[1] = real(-2.01362266f) * x.n[0] + real(0.221551373f) * x.n[1] +
             real(-1.06107954f) * x.n[2] + real(2.83887202f) * x.n[3];
    y.n[2] = real(-7.31010495f) * x.n[0] + real(13.985598f) * x.n[1] +
             real(-0.114305766f) * x.n[2] + real(-7.43618994f) * x.n[3];
    y.n[3] = real(-15.8954216f) * x.n[0] + real(79.6186327f) * x.n[1] +
             real(-127.457279f) * x.n[2] + real(63.7349457f) * x.n[3];
    return y;
}

SHEER_FN RoundedNumbers eight_even_back(RoundedNumbers x)
{
    RoundedNumbers y = x;
    y.n[0] = real(-0.976220279f) * x.n[0] + real(-0.45613926f) * x.n[1] +
             real(-0.0504335521f) * x.n[2] + real(0.000838800391f) * x.n[3];
    y.n[1] = real(-1.04828342f) * x.n[0] + real(-0.229726641f) * x.n[1] +
             real(0.0259608335f) * x.n[2] + real(-0.00133632693f) * x.n[3];
    y.n[2] = real(-1.03115269f) * x.n[0] + real(-0.0778444208f) * x.n[1] +
             real(0.00443408851f) * x.n[2] + real(-0.0103744938f) * x.n[3];
    y.n[3] = real(-0.996038443f) * x.n[0] + real(0.0175438624f) * x.n[1] +
             real(-0.0361414253f) * x.n[2] + real(-0.00317839994f) * x.n[3];
    return y;
}

// What is added so that each begins at 0.
SHEER_FN RoundedNumbers six_even_offsets()
{
    RoundedNumbers offset;
    offset.n[0] = real(0.0f);
    offset.n[1] = real(0.0f);
    offset.n[2] = real(0.018888946f);
    offset.n[3] = real(0.0f);
    return offset;
}

SHEER_FN RoundedNumbers eight_even_offsets()
{
    RoundedNumbers offset;
    offset.n[0] = real(0.972481994f);
    offset.n[1] = real(1.0f);
    offset.n[2] = real(0.999179193f);
    offset.n[3] = real(0.991778293f);
    return offset;
}

SHEER_FN RoundedNumbers rounded_numbers(RoundedNumbers x, RoundedNumbers offset, int count)
{
    for (int i = 0; i < count; ++i) x.n[i] = unorm16(x.n[i] + offset.n[i]) - offset.n[i];
    return x;
}

SHEER_FN RoundedNumbers half_offsets()
{
    RoundedNumbers offset;
    for (int i = 0; i < 4; ++i) offset.n[i] = real(0.5f);
    return offset;
}

// `odd`: moments 1, 3, ..; `even`: 2, 4, ..; `count` of each, 3 or 4.
SHEER_FN RoundedNumbers odd_as_unorm16(RoundedNumbers odd, int count)
{
    if (count == 3) {
        return six_odd_back(rounded_numbers(six_odd(odd), half_offsets(), 3));
    }
    return eight_odd_back(rounded_numbers(eight_odd(odd), half_offsets(), 4));
}

SHEER_FN RoundedNumbers even_as_unorm16(RoundedNumbers even, int count)
{
    if (count == 3) {
        return six_even_back(rounded_numbers(six_even(even), six_even_offsets(), 3));
    }
    return eight_even_back(rounded_numbers(eight_even(even), eight_even_offsets(), 4));
}
