using Msisf.Core.Attitude;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Xunit;

namespace Msisf.Adapters.Tests.Ccsds;

public sealed class AemTests
{
    private const string Quaternion = "0.0 0.0 0.70710678 0.70710678";

    /// <summary>
    /// The matrix of the standard (504.0-B-1, annex) for q = (0, 0, sin 45, cos 45) has the rows (0 1 0), (-1 0 0), (0 0 1): it gives B's
    /// components of a vector in A. So B's x axis lies along A's y.
    /// </summary>
    [Fact]
    public void ReadAem_FromAToB_TurnsBodyAxesIntoTheFrame()
    {
        AttitudeBlock block = Assert.Single(CcsdsTexts.ReadAem(CcsdsTexts.Aem));

        UnitQuaternion frameFromBody = block.Samples.At(CcsdsTexts.Noon + 60.0);

        AssertNear(Vector3D.UnitY, frameFromBody * Vector3D.UnitX);
        Assert.Null(block.MoonMeFromFrame);
    }

    /// <summary>Half of the time, half of the turn: linear where the file says nothing.</summary>
    [Fact]
    public void ReadAem_BetweenTwo_TurnsAtConstantRate()
    {
        UnitQuaternion half = Assert.Single(CcsdsTexts.ReadAem(CcsdsTexts.Aem)).Samples.At(CcsdsTexts.Noon + 20.0);

        AssertNear(new Vector3D(Math.Cos(Math.PI / 6.0), Math.Sin(Math.PI / 6.0), 0.0), half * Vector3D.UnitX);
    }

    /// <summary>The same attitude, written in other ways.</summary>
    [Theory]
    [InlineData("A2B", "B2A", Quaternion, "0.0 0.0 -0.70710678 0.70710678")]
    [InlineData("LAST", "FIRST", Quaternion, "0.70710678 0.0 0.0 0.70710678")]
    [InlineData("", "", Quaternion, "0.0 0.0 -0.70710678 -0.70710678")]
    [InlineData(
        "REF_FRAME_A = EME2000\nREF_FRAME_B = SC_BODY_1", "REF_FRAME_A = SC_BODY_1\nREF_FRAME_B = EME2000", Quaternion,
        "0.0 0.0 -0.70710678 0.70710678")]
    [InlineData("TYPE = QUATERNION\n", "TYPE = QUATERNION/DERIVATIVE\n", Quaternion, Quaternion + " 0 0 0.01 -0.01")]
    public void ReadAem_OtherConvention_IsTheSameAttitude(string key, string otherKey, string numbers, string otherNumbers)
    {
        string text = CcsdsTexts.Aem.Replace(numbers, otherNumbers, StringComparison.Ordinal);
        text = key.Length > 0 ? text.Replace(key, otherKey, StringComparison.Ordinal) : text;
        text = text.Replace("0.0 0.0 0.0 1.0", otherKey == "FIRST" ? "1 0 0 0" : otherKey.Contains("DERIV", StringComparison.Ordinal)
            ? "0 0 0 1 0 0 0.01 0" : "0 0 0 1", StringComparison.Ordinal);

        UnitQuaternion frameFromBody = Assert.Single(CcsdsTexts.ReadAem(text)).Samples.At(CcsdsTexts.Noon + 60.0);

        AssertNear(Vector3D.UnitY, frameFromBody * Vector3D.UnitX);
    }

    /// <summary>Version 2.0: from A to B, scalar last, angles in the order of the sequence.</summary>
    [Theory]
    [InlineData("QUATERNION", "", "0 0 0.70710678 0.70710678")]
    [InlineData("QUATERNION/ANGVEL", "ANGVEL_FRAME = SC_BODY_1\n", "0 0 0.70710678 0.70710678 0 0 1.5")]
    [InlineData("EULER_ANGLE", "EULER_ROT_SEQ = ZXZ\n", "60 0 30")]
    [InlineData("EULER_ANGLE/ANGVEL", "EULER_ROT_SEQ = 321\nANGVEL_FRAME = SC_BODY_1\n", "90 0 0 0 0 1.5")]
    public void ReadAem_SecondVersion_IsRead(string type, string keys, string numbers)
    {
        string text = CcsdsTexts.Aem.Replace("VERS = 1.0", "VERS = 2.0", StringComparison.Ordinal)
            .Replace("ATTITUDE_DIR = A2B\n", string.Empty, StringComparison.Ordinal)
            .Replace("TYPE = QUATERNION\nQUATERNION_TYPE = LAST\n", $"TYPE = {type}\n{keys}", StringComparison.Ordinal)
            .Replace(Quaternion, numbers, StringComparison.Ordinal)
            .Replace("2024-01-19T12:00:00.000 0.0 0.0 0.0 1.0\n", string.Empty, StringComparison.Ordinal);

        UnitQuaternion frameFromBody = Assert.Single(CcsdsTexts.ReadAem(text)).Samples.At(CcsdsTexts.Noon + 60.0);

        AssertNear(Vector3D.UnitY, frameFromBody * Vector3D.UnitX);
    }

    /// <summary>
    /// A body that turns by 1.5 deg/s about z: of three samples a minute apart, a polynomial through values and rates knows the turn
    /// between, which goes nearly around once.
    /// </summary>
    [Theory]
    [InlineData("QUATERNION/RATE", "RATE_FRAME = REF_FRAME_B", "0 0 1.5")]
    [InlineData("QUATERNION/RATE", "RATE_FRAME = EME2000", "0 0 1.5")]
    [InlineData("QUATERNION/DERIVATIVE", "", null)]
    public void ReadAem_HermiteWithRates_FollowsTheTurn(string type, string rateFrame, string? rates)
    {
        const double Rate = 1.5 * Math.PI / 180.0;
        string head = CcsdsTexts.Aem[..CcsdsTexts.Aem.IndexOf("2024-01-19T12:00:00.000 0.0", StringComparison.Ordinal)]
            .Replace("TYPE = QUATERNION\n", $"TYPE = {type}\n", StringComparison.Ordinal)
            .Replace(
                "META_STOP", $"{rateFrame}\nINTERPOLATION_METHOD = HERMITE\nINTERPOLATION_DEGREE = 7\nMETA_STOP",
                StringComparison.Ordinal);
        IEnumerable<string> lines = Enumerable.Range(0, 8).Select(i =>
        {
            (double sin, double cos) = Math.SinCos(5.0 * i * Rate);
            FormattableString line = $"2024-01-19T12:{i / 6:D2}:{10 * (i % 6):D2} 0 0 {sin:F12} {cos:F12} ";
            FormattableString derivative = $"0 0 {Rate / 2.0 * cos:F12} {-Rate / 2.0 * sin:F12}";
            return FormattableString.Invariant(line) + (rates ?? FormattableString.Invariant(derivative));
        });

        UnitQuaternion turned = Assert.Single(CcsdsTexts.ReadAem(head + string.Join('\n', lines))).Samples.At(CcsdsTexts.Noon + 35.0);

        AssertNear(new Vector3D(Math.Cos(35.0 * Rate), Math.Sin(35.0 * Rate), 0.0), turned * Vector3D.UnitX, 1e-7);
    }

    /// <summary>
    /// A spinner whose three angles change at constant rates, with lines 30 s apart: the angles between the lines go on at these rates, and
    /// so do both directions of the turn, version 1.0 and rates about the spacecraft's axes.
    /// </summary>
    [Theory]
    [InlineData("2.0", "EULER_ANGLE/DERIVATIVE", "ZXZ", "REF_FRAME_A = EME2000\nREF_FRAME_B = SC_BODY_1", false)]
    [InlineData("2.0", "EULER_ANGLE/DERIVATIVE", "321", "REF_FRAME_A = SC_BODY_1\nREF_FRAME_B = EME2000", true)]
    [InlineData("1.0", "EULER_ANGLE/RATE", "XYZ", "REF_FRAME_A = EME2000\nREF_FRAME_B = SC_BODY_1", false)]
    public void ReadAem_AnglesWithDerivatives_GoOnBetweenLines(string version, string type, string sequence, string frames, bool turnsBack)
    {
        string head = CcsdsTexts.Aem[..CcsdsTexts.Aem.IndexOf("2024-01-19T12:00:00.000 0.0", StringComparison.Ordinal)]
            .Replace("VERS = 1.0", $"VERS = {version}", StringComparison.Ordinal)
            .Replace("REF_FRAME_A = EME2000\nREF_FRAME_B = SC_BODY_1", frames, StringComparison.Ordinal)
            .Replace("ATTITUDE_DIR = A2B\n", version == "1.0" ? "ATTITUDE_DIR = A2B\n" : string.Empty, StringComparison.Ordinal)
            .Replace(
                "TYPE = QUATERNION\nQUATERNION_TYPE = LAST\n", $"TYPE = {type}\nEULER_ROT_SEQ = {sequence}\n", StringComparison.Ordinal);
        IEnumerable<string> lines = Enumerable.Range(0, 12).Select(i => FormattableString.Invariant(
            $"2024-01-19T12:{i / 2:D2}:{30 * (i % 2):D2} {(10 + (45 * i)) % 360} {20 + (3 * i)} {(-10 - (30 * i)) % 360} 1.5 0.1 -1"));

        IAttitudeSamples samples = Assert.Single(CcsdsTexts.ReadAem(head + string.Join('\n', lines))).Samples;

        const double Seconds = 100.0;
        double[] angles =
        [
            .. new[] { 10.0 + (1.5 * Seconds), 20.0 + (0.1 * Seconds), -10.0 - Seconds }.Select(double.DegreesToRadians),
        ];
        UnitQuaternion turned = EulerSequence.Parse(sequence).FrameFromBody(angles);
        UnitQuaternion expected = turnsBack ? turned.Conjugate : turned;
        UnitQuaternion actual = samples.At(CcsdsTexts.Noon + Seconds);
        foreach (Vector3D axis in (Vector3D[])[Vector3D.UnitX, Vector3D.UnitY])
        {
            AssertNear(expected * axis, actual * axis, 1e-7); // s of a time in TDB, times 0.03 rad/s
        }

        Assert.NotNull(samples.RateAt(CcsdsTexts.Noon + Seconds));
    }

    /// <summary>Rates that lines state are used where the file says nothing of interpolation, and where it says something else.</summary>
    [Theory]
    [InlineData("")]
    [InlineData("INTERPOLATION_METHOD = LINEAR\n")]
    [InlineData("INTERPOLATION_METHOD = LAGRANGE\nINTERPOLATION_DEGREE = 1\n")]
    public void ReadAem_StatedRates_AreTheRates(string interpolation)
    {
        string text = CcsdsTexts.Aem.Replace("VERS = 1.0", "VERS = 2.0", StringComparison.Ordinal)
            .Replace("ATTITUDE_DIR = A2B\n", string.Empty, StringComparison.Ordinal)
            .Replace(
                "TYPE = QUATERNION\nQUATERNION_TYPE = LAST\n", $"TYPE = QUATERNION/ANGVEL\nANGVEL_FRAME = SC_BODY_1\n{interpolation}",
                StringComparison.Ordinal)
            .Replace("0.0 0.0 0.0 1.0", "0.0 0.0 0.0 1.0 1 2 3", StringComparison.Ordinal)
            .Replace(Quaternion, Quaternion + " 4 5 6", StringComparison.Ordinal);

        Vector3D rate = Assert.Single(CcsdsTexts.ReadAem(text)).Samples.RateAt(CcsdsTexts.Noon + 60.0)!.Value;

        AssertNear(Math.PI / 180.0 * new Vector3D(4.0, 5.0, 6.0), rate, 1e-7);
    }

    [Fact]
    public void ReadAem_RoundedQuaternion_IsReadIfAsked()
    {
        string text = CcsdsTexts.Aem.Replace(Quaternion, "0.0 0.0 0.708 0.7075", StringComparison.Ordinal);

        AssertNear(
            Vector3D.UnitY, CcsdsTexts.ReadAem(text, isRounded: true)[0].Samples.At(CcsdsTexts.Noon + 60.0) * Vector3D.UnitX, 1e-3);
        Assert.Equal(
            "turn.aem, line 18: the quaternion has length 1.0009; 1 within 1E-05 is needed. Check its numbers, or give --normalize if they "
                + "are rounded.",
            Assert.Throws<BadInputException>(() => CcsdsTexts.ReadAem(text)).Message);
    }

    [Theory]
    [InlineData("ATTITUDE_DIR = A2B\n", "", "14: the block above has no ATTITUDE_DIR (A2B or B2A), so both are possible. Add it.")]
    [InlineData("QUATERNION_TYPE = LAST\n", "", "13: ATTITUDE_TYPE = 'QUATERNION': the block has no QUATERNION_TYPE")]
    [InlineData("= QUATERNION\n", "= SPIN\n", "13: ATTITUDE_TYPE = 'SPIN': QUATERNION, QUATERNION/DERIVATIVE,")]
    [InlineData("SC_BODY_1", "ICRF", "8: REF_FRAME_B = 'ICRF': both frames are of space (EME2000, ICRF)")]
    [InlineData("EME2000", "LVLH", "7: REF_FRAME_A = 'LVLH': one of REF_FRAME_A and REF_FRAME_B must be a frame of space")]
    [InlineData("0.70710678 0.70710678", "0.70710678", "18: 3 numbers behind the time; QUATERNION has 4.")]
    [InlineData("VERS = 1.0", "VERS = 3.0", "1: CCSDS_AEM_VERS = '3.0': versions 1.0, 2.0 are read.")]
    [InlineData(
        "= QUATERNION\nQUATERNION_TYPE = LAST", "= EULER_ANGLE\nEULER_ROT_SEQ = 312",
        "17: 4 numbers behind the time; EULER_ANGLE has 3.")]
    [InlineData("12:01:00.000 ", "12:00:00.000 ", "18: the time of the line before occurs again, with other numbers.")]
    public void ReadAem_Wrong_SaysWhereAndWhat(string right, string wrong, string expected)
    {
        BadInputException failure = Assert.Throws<BadInputException>(
            () => CcsdsTexts.ReadAem(CcsdsTexts.Aem.Replace(right, wrong, StringComparison.Ordinal)));

        Assert.StartsWith($"turn.aem, line {expected}", failure.Message);
    }

    /// <summary>In version 1.0 some programs write angles in the order X, Y, Z, others in that of the sequence.</summary>
    [Fact]
    public void ReadAem_FirstVersionWithAnglesInDoubt_IsRefused()
    {
        string text = CcsdsTexts.Aem
            .Replace("= QUATERNION\nQUATERNION_TYPE = LAST", "= EULER_ANGLE\nEULER_ROT_SEQ = 312", StringComparison.Ordinal)
            .Replace("0.0 0.0 0.0 1.0", "0 0 0", StringComparison.Ordinal);

        Assert.StartsWith(
            "turn.aem, line 17: version 1.0 leaves open whether the angles are in the order X, Y, Z or in that of EULER_ROT_SEQ (ZXY).",
            Assert.Throws<BadInputException>(() => CcsdsTexts.ReadAem(text)).Message);
    }

    private static void AssertNear(Vector3D expected, Vector3D actual, double limit = 1e-8) =>
        Assert.InRange((expected - actual).Length, 0.0, limit);
}
