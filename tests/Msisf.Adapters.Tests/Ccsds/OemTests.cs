using Msisf.Core.Ephemeris;
using Msisf.Core.Numerics;
using Msisf.Core.Orbit;
using Msisf.Core.Time;
using System.IO.Compression;
using System.Text;
using Xunit;

namespace Msisf.Adapters.Tests.Ccsds;

public sealed class OemTests
{
    /// <summary>m: times are right to 2e-7 s, in which the spacecraft flies 0.2 mm.</summary>
    private const double OfTime = 1e-3;

    [Fact]
    public void ReadOem_Lines_GivesStatesInMetres()
    {
        List<string> notes = [];

        TrajectoryBlock block = Assert.Single(CcsdsTexts.ReadOem(CcsdsTexts.Oem, notes));

        StateVector state = block.Samples.At(CcsdsTexts.Noon + 90.0);
        Assert.InRange((state.Position - new Vector3D(2_090_000.0, 2250.0, 0.0)).Length, 0.0, OfTime);
        // m/s: thousands of ulps; a wrong unit or column makes far more
        Assert.InRange((state.Velocity - new Vector3D(1000.0, 50.0, 0.0)).Length, 0.0, 1e-4);
        Assert.Equal(301, block.Center);
        Assert.Null(block.MoonMeFromFrame);
        Assert.Empty(notes);
    }

    /// <summary>2024-01-19T12:00:00 UTC in other systems, by astropy.time (ERFA): TDB there is within 30 microseconds of SPICE's.</summary>
    [Theory]
    [InlineData("TAI", "12:00:37.000", 2e-7)]
    [InlineData("GPS", "12:00:18.000", 2e-7)]
    [InlineData("TT", "12:01:09.184", 2e-7)]
    [InlineData("TDB", "12:01:09.184411914", 5e-5)]
    [InlineData("utc", "12:00:00Z", 0.0)]
    public void ReadOem_TimeSystem_IsTheSameInstant(string system, string time, double limit)
    {
        string text = CcsdsTexts.Oem.Replace("TIME_SYSTEM = UTC", $"TIME_SYSTEM = {system}", StringComparison.Ordinal)
            .Replace("\n2024-01-19T12:00:00.000", $"\n2024-01-19T{time}", StringComparison.Ordinal)
            .Replace("12:01:00.000", "12:01:30", StringComparison.Ordinal);

        double first = Assert.Single(CcsdsTexts.ReadOem(text)).Samples.Times.First.Seconds;

        Assert.Equal(CcsdsTexts.Noon, first, limit);
    }

    /// <summary>By astropy 1999-01-01T00:00:00 UTC is -31579135.816114 TDB; half a second before it is a leap second.</summary>
    [Fact]
    public void ReadOem_LeapSecond_CountsOn()
    {
        string text = WithTimes("1998-12-31T23:59:59.5", "1998-12-31T23:59:60.5", "1999-001T00:00:00", "1999-01-01T00:00:01");

        SampleTimes times = Assert.Single(CcsdsTexts.ReadOem(text)).Samples.Times;

        // s: 30 microseconds, as above, and half of the last digit.
        Assert.Equal(-31579137.316114, times[0].Seconds, 5e-5);
        Assert.Equal(-31579136.316114, times[1].Seconds, 5e-5);
        Assert.Equal(-31579135.816114, times[2].Seconds, 5e-5);
    }

    [Theory]
    [InlineData("MOON", "EME2000", 301, false)]
    [InlineData("LUNA", "ICRF", 301, false)]
    [InlineData("Earth", "gcrf", 399, false)]
    [InlineData("MOON", "MOON_ME", 301, true)]
    [InlineData("MOON", "MOON_PA", 301, true)]
    public void ReadOem_CenterAndFrame_AreTaken(string center, string frame, int number, bool turns)
    {
        string text = CcsdsTexts.Oem.Replace("= MOON", $"= {center}", StringComparison.Ordinal)
            .Replace("EME2000", frame, StringComparison.Ordinal);

        TrajectoryBlock block = Assert.Single(CcsdsTexts.ReadOem(text));

        Assert.Equal(number, block.Center);
        Assert.Equal(turns, block.MoonMeFromFrame is not null);
        Assert.Equal(frame == "MOON_PA" ? RotationMatrix.FrameAboutX(1e-3) : turns ? RotationMatrix.Identity : null, block.MoonMeFromFrame);
    }

    [Fact]
    public void ReadOem_NothingSaidOfInterpolation_IsHermiteOfDegreeSeven()
    {
        string text = CcsdsTexts.Oem.Replace("INTERPOLATION = HERMITE\nINTERPOLATION_DEGREE = 7\n", string.Empty, StringComparison.Ordinal);

        Assert.Equal(
            new Interpolation(InterpolationMethod.Hermite, 7), Assert.Single(CcsdsTexts.ReadOem(text)).Samples.Interpolation);
    }

    [Theory]
    [InlineData("LAGRANGE", "5", InterpolationMethod.Lagrange, 5, 6)]
    [InlineData("Hermite", "3", InterpolationMethod.Hermite, 3, 2)]
    [InlineData("LINEAR", "1", InterpolationMethod.Linear, 1, 2)]
    public void ReadOem_Interpolation_IsAsTheFileSays(string method, string degree, InterpolationMethod expected, int number, int samples)
    {
        string text = CcsdsTexts.Oem.Replace("HERMITE", method, StringComparison.Ordinal)
            .Replace("DEGREE = 7", $"DEGREE = {degree}", StringComparison.Ordinal);

        Interpolation interpolation = Assert.Single(CcsdsTexts.ReadOem(text)).Samples.Interpolation;

        Assert.Equal(new Interpolation(expected, number), interpolation);
        Assert.Equal(samples, interpolation.Samples);
    }

    [Fact]
    public void ReadOem_TwoBlocksCovarianceAccelerationsUseable_AreRead()
    {
        string second = CcsdsTexts.Oem[CcsdsTexts.Oem.IndexOf("META_START", StringComparison.Ordinal)..]
            .Replace("2024-01-19T12", "2024-01-19T13", StringComparison.Ordinal)
            .Replace("STOP_TIME = ", "USEABLE_START_TIME = 2024-019T13:00:30\nUSEABLE_STOP_TIME = 2024-019T13:02:30\nSTOP_TIME = ",
                StringComparison.Ordinal)
            .Replace("1.0 0.0 0.0\n", "1.0 0.0 0.0 0.0 0.0 0.0\n", StringComparison.Ordinal);
        string text = CcsdsTexts.Oem
            + "COVARIANCE_START\nEPOCH = 2024-01-19T12:00:00\nCOV_REF_FRAME = RTN\n1.0\n0.1 1.0\nCOVARIANCE_STOP\n" + second;

        IReadOnlyList<TrajectoryBlock> blocks = CcsdsTexts.ReadOem(text.Replace("VERS = 2.0", "VERS = 3.0", StringComparison.Ordinal));

        Assert.Equal([4, 4], blocks.Select(block => block.Samples.Count));
        // s: TDB - TT changes by less within some hours.
        Assert.Equal(CcsdsTexts.Noon + 3630.0, blocks[1].Samples.Cover.Start, 1e-5);
        Assert.Equal(CcsdsTexts.Noon + 3750.0, blocks[1].Samples.Cover.End, 1e-5);
    }

    [Fact]
    public void ReadOem_GzipAndByteOrderMark_AreTheSame()
    {
        using MemoryStream packed = new();
        using (GZipStream gzip = new(packed, CompressionLevel.Fastest, leaveOpen: true))
        {
            gzip.Write([0xEF, 0xBB, 0xBF, .. Encoding.UTF8.GetBytes(CcsdsTexts.Oem.Replace("\n", "\r\n", StringComparison.Ordinal))]);
        }

        Assert.Equal(
            CcsdsTexts.ReadOem(CcsdsTexts.Oem)[0].Samples[3], Assert.Single(CcsdsTexts.ReadOem(packed.ToArray())).Samples[3]);
    }

    /// <summary>What writers get wrong, where it can be meant in one way only.</summary>
    [Theory]
    [InlineData("OBJECT_NAME = ORBITER\n", "", "line 15: The block has no OBJECT_NAME")]
    [InlineData(" 2060.0 ", "\t2060.0\t", "line 18: TABs are where the standard has blanks")]
    [InlineData(
        "CENTER_NAME = MOON\nREF_FRAME = EME2000", "REF_FRAME = EME2000\nCENTER_NAME = MOON", "line 10: The keywords are not in the order")]
    [InlineData("META_START\n", "", "line 6: META_START is missing")]
    [InlineData("META_STOP\n", "", "line 16: META_STOP is missing")]
    [InlineData("2060.0", "2.060D+03", "line 18: Numbers have Fortran's D for the exponent")]
    [InlineData("DEGREE = 7", "DEGREE = 6", "HERMITE 6 needs an odd degree; 7 is used.")]
    [InlineData("OBJECT_ID = 2024-001A", "OBJECT_ID = 2024-001A\nQUALITY_OF_FIT = 1", "'QUALITY_OF_FIT' is not known; it is left out.")]
    [InlineData("DEGREE = 7", "DEGREE = 9", "HERMITE 9 needs 5 states, a block has 4")]
    [InlineData(
        "2024-01-19T12:01:00.000 2060.0 1.0 0.0 1.0 0.0333333333333 0.0\n",
        "2024-01-19T12:01:00.000 2060.0 1.0 0.0 1.0 0.0333333333333 0.0\n2024-01-19T12:01:00 2060 1 0 1 0.0333333333333 0\n",
        "line 19: A line occurs twice; the second one is left out.")]
    [InlineData(
        "START_TIME = 2024-01-19T12:00:00.000", "START_TIME = 2024-01-19T11:00:00.000",
        "START_TIME = '2024-01-19T11:00:00.000' is not the time of the block's first line, 2024-01-19T12:00:00Z (UTC); the lines count.")]
    [InlineData(
        "STOP_TIME = 2024-01-19T12:03:00.000", "STOP_TIME = 2024-01-20",
        "STOP_TIME = '2024-01-20' is not the time of the block's last line, 2024-01-19T12:03:00Z (UTC); the lines count.")]
    [InlineData("OBJECT_ID = 2024-001A", "OBJECT_ID = none\nLINES = 4", "'LINES' is not known; it is left out.")]
    public void ReadOem_SmallFault_IsReadWithANote(string right, string wrong, string expected)
    {
        List<string> notes = [];

        TrajectoryBlock block = Assert.Single(
            CcsdsTexts.ReadOem(CcsdsTexts.Oem.Replace(right, wrong, StringComparison.Ordinal), notes));

        Assert.InRange((block.Samples.At(CcsdsTexts.Noon + 90.0).Position - new Vector3D(2_090_000.0, 2250.0, 0.0)).Length, 0.0, OfTime);
        Assert.Contains(expected, Assert.Single(notes));
        Assert.StartsWith("orbit.oem, line ", notes[0]);
    }

    /// <summary>
    /// Circular orbits, a line each minute: what their curvature says of unit and centre, against what the file says. GM (km^3/s^2) of
    /// DE421.
    /// </summary>
    [Theory]
    [InlineData("MOON", 1838.0, 4902.800076, 1.0, null)]
    [InlineData("EARTH", 42164.0, 398600.436, 1.0, null)]
    [InlineData("MOON", 1838.0, 4902.800076, 1000.0, "curve as an orbit about the Moon in m does, but an OEM has km and km/s.")]
    [InlineData("EARTH", 6778.0, 398600.436, 1000.0, "curve as an orbit about the Earth in m does, but an OEM has km and km/s.")]
    [InlineData("EARTH", 1838.0, 4902.800076, 1.0, "curve as an orbit about the Moon in km does, but CENTER_NAME is EARTH.")]
    [InlineData("MOON", 6778.0, 398600.436, 1.0, "curve as an orbit about the Earth in km does, but CENTER_NAME is MOON.")]
    public void ReadOem_CurvatureOfAnotherUnitOrCentre_IsNoted(string center, double radius, double gm, double scale, string? expected)
    {
        double rate = Math.Sqrt(gm / (radius * radius * radius));
        IEnumerable<string> lines = Enumerable.Range(0, 30).Select(i =>
        {
            (double sin, double cos) = Math.SinCos(60.0 * i * rate);
            (double r, double v) = (scale * radius, scale * radius * rate);
            return FormattableString.Invariant(
                $"2024-01-19T12:{i:00}:00 {r * cos:F9} {r * sin:F9} 0 {-v * sin:F12} {v * cos:F12} 0");
        });
        string head = CcsdsTexts.Oem[..CcsdsTexts.Oem.IndexOf("2024-01-19T12:00:00.000 2000", StringComparison.Ordinal)]
            .Replace("CENTER_NAME = MOON", $"CENTER_NAME = {center}", StringComparison.Ordinal)
            .Replace("STOP_TIME = 2024-01-19T12:03", "STOP_TIME = 2024-01-19T12:29", StringComparison.Ordinal);
        List<string> notes = [];

        TrajectoryBlock block = Assert.Single(CcsdsTexts.ReadOem(head + string.Join('\n', lines), notes));

        Assert.Equal(1000.0 * scale * radius, block.Samples[0].Position.X, 1e-3); // read as it stands
        if (expected is null)
        {
            Assert.Empty(notes);
        }
        else
        {
            Assert.Contains(expected, Assert.Single(notes), StringComparison.Ordinal);
        }
    }

    /// <summary>Heads as GMAT (with its name of the Moon) and Orekit write them.</summary>
    [Theory]
    [InlineData(
        "CCSDS_OEM_VERS = 1.0\nCREATION_DATE  = 2024-01-18T12:13:46\nORIGINATOR     = GMAT USER\n\nMETA_START\n"
            + "OBJECT_NAME          = DefaultSC\nOBJECT_ID            = SatId\nCENTER_NAME          = Luna\n"
            + "REF_FRAME            = ICRF\nTIME_SYSTEM          = UTC\nSTART_TIME           = 2024-01-19T12:00:00.000\n"
            + "USEABLE_START_TIME   = 2024-01-19T12:00:00.000\nUSEABLE_STOP_TIME    = 2024-01-19T12:03:00.000\n"
            + "STOP_TIME            = 2024-01-19T12:03:00.000\nINTERPOLATION        = Lagrange\nINTERPOLATION_DEGREE = 3\nMETA_STOP\n")]
    [InlineData(
        "CCSDS_OEM_VERS = 3.0\nCREATION_DATE = 2024-01-18T12:13:46.123\nORIGINATOR = OREKIT\nMESSAGE_ID = 1\n\nMETA_START\n"
            + "OBJECT_NAME = ORBITER\nOBJECT_ID = 2024-001A\nCENTER_NAME = MOON\nREF_FRAME = GCRF\nTIME_SYSTEM = UTC\n"
            + "START_TIME = 2024-01-19T12:00:00.0\nSTOP_TIME = 2024-01-19T12:03:00.0\nINTERPOLATION = HERMITE\n"
            + "INTERPOLATION_DEGREE = 3\nMETA_STOP\n")]
    public void ReadOem_HeadsOfOtherPrograms_AreReadWithoutANote(string head)
    {
        List<string> notes = [];
        string lines = CcsdsTexts.Oem[CcsdsTexts.Oem.IndexOf("2024-01-19T12:00:00.000 2000", StringComparison.Ordinal)..];

        TrajectoryBlock block = Assert.Single(CcsdsTexts.ReadOem(head + lines, notes));

        Assert.InRange((block.Samples.At(CcsdsTexts.Noon + 90.0).Position - new Vector3D(2_090_000.0, 2250.0, 0.0)).Length, 0.0, OfTime);
        Assert.Equal(301, block.Center);
        Assert.Empty(notes);
    }

    [Fact]
    public void ReadOem_NoVelocities_TakesPositionsAlone()
    {
        List<string> notes = [];
        string text = string.Join('\n', CcsdsTexts.Oem.Split('\n').Select(line => line.StartsWith("2024", StringComparison.Ordinal)
            ? string.Join(' ', [.. line.Split(' ')[..4], "0", "0", "0"])
            : line));

        TrajectoryBlock block = Assert.Single(CcsdsTexts.ReadOem(text, notes));

        // m: noon is here the nearest double, whose step of 1.2e-7 s is 0.1 mm
        Assert.InRange((block.Samples.At(CcsdsTexts.Noon + 90.0).Position - new Vector3D(2_090_000.0, 2250.0, 0.0)).Length, 0.0, 1e-4);
        Assert.Contains("LAGRANGE of that degree is used", notes[0]);
    }

    /// <summary>Parts that were joined without a new block, as in Artemis I's file; or velocities in m/s.</summary>
    [Theory]
    [InlineData(
        " 2120.0 4.0", " 2140.0 4.0", "orbit.oem, line 19: position and velocity contradict those of the line before, and so 2 times")]
    [InlineData(" 0.0666666666667 ", " 66.6666666667 ", "so 2 times, most in line 20 by ")]
    public void ReadOem_LinesThatContradictEachOther_AreNamed(string right, string wrong, string expected)
    {
        List<string> notes = [];

        CcsdsTexts.ReadOem(CcsdsTexts.Oem.Replace(right, wrong, StringComparison.Ordinal), notes);

        Assert.Contains(expected, Assert.Single(notes));
    }

    /// <summary>Time, position and velocity are 64 bytes; nothing else is allocated for a line, so ten million need 640 MB.</summary>
    [Fact]
    public void ReadOem_ManyStates_Takes64BytesEach()
    {
        const int Count = 160_000;
        StringBuilder text = new(CcsdsTexts.Oem[..CcsdsTexts.Oem.IndexOf("2024-01-19T12:00:00.000 2000", StringComparison.Ordinal)]);
        DateTime start = new(2024, 1, 19, 0, 0, 0, DateTimeKind.Utc);
        for (int i = 0; i < Count; i++)
        {
            text.Append(start.AddSeconds(i).ToString("s", System.Globalization.CultureInfo.InvariantCulture))
                .Append(" 2000.0 1.5 -3.25 1.0 0.5 0.25\n");
        }

        byte[] bytes = Encoding.ASCII.GetBytes(text.ToString());
        CcsdsTexts.ReadOem(CcsdsTexts.Oem); // its own constants
        long before = GC.GetAllocatedBytesForCurrentThread();
        IReadOnlyList<TrajectoryBlock> blocks = CcsdsTexts.ReadOem(bytes);
        long used = GC.GetAllocatedBytesForCurrentThread() - before;

        Assert.Equal(Count, blocks[0].Samples.Count);
        Assert.InRange((double)used / Count, 58.0, 72.0);
    }

    private static string WithTimes(params string[] times)
    {
        string[] lines = CcsdsTexts.Oem.Split('\n');
        int next = 0;
        return string.Join('\n', lines.Select(line => line.StartsWith("2024", StringComparison.Ordinal)
            ? times[next++] + line[line.IndexOf(' ', StringComparison.Ordinal)..]
            : line));
    }
}
