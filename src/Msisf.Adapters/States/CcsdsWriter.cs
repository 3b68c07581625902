namespace Msisf.Adapters.States;

/// <summary>Writes states as CCSDS files: an orbit ephemeris message (OEM 2.0) and an attitude ephemeris message (AEM 1.0).</summary>
public static class CcsdsWriter
{
    /// <summary>The degree between lines, where there are enough.</summary>
    private const int HighestDegree = 7;

    private const double KilometresPerMetre = 1e-3;

    /// <summary>Positions and velocities.</summary>
    /// <param name="writer">Gets the text.</param>
    /// <param name="head">One line about the file.</param>
    /// <param name="states">In the order of time.</param>
    public static void WriteOem(TextWriter writer, string head, IReadOnlyList<InertialState> states)
    {
        Begin(writer, "CCSDS_OEM_VERS = 2.0", head, states);
        writer.WriteLine(
            "COMMENT km and km/s about the Moon's centre, along the axes of SPICE's J2000 (ICRF)");
        writer.WriteLine("OBJECT_NAME = MSIS CAMERA");
        writer.WriteLine("OBJECT_ID = NONE");
        writer.WriteLine("CENTER_NAME = MOON");
        writer.WriteLine("REF_FRAME = EME2000");
        Times(writer, states);
        if (states.Count > 1)
        {
            writer.WriteLine("INTERPOLATION = LAGRANGE");
            writer.WriteLine(Invariant($"INTERPOLATION_DEGREE = {Math.Min(HighestDegree, states.Count - 1)}"));
        }

        writer.WriteLine("META_STOP");
        foreach (InertialState state in states)
        {
            writer.WriteLine($"{StateTables.Calendar(state.Time)} " + StateTables.Line(
                ' ',
                [
                    .. StateTables.Numbers(KilometresPerMetre * state.State.Position),
                    .. StateTables.Numbers(KilometresPerMetre * state.State.Velocity),
                ]));
        }
    }

    /// <summary>Attitudes.</summary>
    /// <inheritdoc cref="WriteOem"/>
    public static void WriteAem(TextWriter writer, string head, IReadOnlyList<InertialState> states)
    {
        Begin(writer, "CCSDS_AEM_VERS = 1.0", head, states);
        writer.WriteLine("COMMENT SC_BODY_1 are camera axes: looks along -x, y right in the image, z up; Q1 Q2 Q3 QC, scalar last");
        writer.WriteLine("OBJECT_NAME = MSIS CAMERA");
        writer.WriteLine("OBJECT_ID = NONE");
        writer.WriteLine("CENTER_NAME = MOON");
        writer.WriteLine("REF_FRAME_A = EME2000");
        writer.WriteLine("REF_FRAME_B = SC_BODY_1");
        writer.WriteLine("ATTITUDE_DIR = A2B");
        Times(writer, states);
        bool hasRates = states.All(state => state.RateJ2000 is not null);
        writer.WriteLine($"ATTITUDE_TYPE = QUATERNION{(hasRates ? "/DERIVATIVE" : string.Empty)}");
        writer.WriteLine("QUATERNION_TYPE = LAST");
        writer.WriteLine($"INTERPOLATION_METHOD = {(hasRates ? "HERMITE" : "LINEAR")}");
        writer.WriteLine($"INTERPOLATION_DEGREE = {(hasRates ? 3 : 1)}");
        writer.WriteLine("META_STOP");
        writer.WriteLine("DATA_START");
        foreach (InertialState state in states)
        {
            UnitQuaternion q = state.J2000FromCamera;
            double[] derivative = hasRates ? Derivative(q, state.RateJ2000!.Value) : [];
            writer.WriteLine($"{StateTables.Calendar(state.Time)} {StateTables.Line(' ', [q.X, q.Y, q.Z, q.W, .. derivative])}");
        }

        writer.WriteLine("DATA_STOP");
    }

    /// <summary>The derivative of a quaternion, scalar last, 1/s: half the rate times it.</summary>
    /// <param name="rate">rad/s along the axes to which it turns.</param>
    private static double[] Derivative(UnitQuaternion q, Vector3D rate)
    {
        Vector3D v = new(q.X, q.Y, q.Z);
        return [.. StateTables.Numbers(0.5 * ((q.W * rate) + Vector3D.Cross(rate, v))), -0.5 * Vector3D.Dot(rate, v)];
    }

    private static void Begin(TextWriter writer, string version, string head, IReadOnlyList<InertialState> states)
    {
        writer.WriteLine(version);
        writer.WriteLine($"COMMENT {head}");
        if (states.Count == 1)
        {
            writer.WriteLine("COMMENT one state alone: its velocity is 0 where nothing says it");
        }

        // The standard demands a date; that of the first state keeps the bytes the same from call to call.
        writer.WriteLine($"CREATION_DATE = {StateTables.Calendar(states[0].Time)}");
        writer.WriteLine("ORIGINATOR = MSISF");
        writer.WriteLine("META_START");
    }

    private static void Times(TextWriter writer, IReadOnlyList<InertialState> states)
    {
        writer.WriteLine("TIME_SYSTEM = UTC");
        writer.WriteLine($"START_TIME = {StateTables.Calendar(states[0].Time)}");
        writer.WriteLine($"STOP_TIME = {StateTables.Calendar(states[^1].Time)}");
    }
}
