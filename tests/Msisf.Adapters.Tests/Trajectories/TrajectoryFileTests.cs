using Msisf.Adapters.Ccsds;
using Msisf.Adapters.Input;
using Msisf.Adapters.Tests.Ccsds;
using Msisf.Adapters.Trajectories;
using Msisf.Core.Ephemeris;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Orbit;
using Xunit;

namespace Msisf.Adapters.Tests.Trajectories;

/// <summary>Ephemerides of STK and vectors of JPL Horizons; the layouts are those of their programs, the numbers made by hand.</summary>
public sealed class TrajectoryFileTests
{
    /// <summary>s: TDB of UTC is right to 2e-7 s.</summary>
    private const double OfTime = 1e-6;

    private const string Stk = """
        stk.v.12.0

        # WrittenBy    STK_v12.2.0

        BEGIN Ephemeris

            NumberOfEphemerisPoints		 4

            ScenarioEpoch		 19 Jan 2024 12:00:00.000000

        # Epoch in JDate format: 2460329.00000000000000

            InterpolationMethod		 Lagrange
            InterpolationSamplesM1		 3
            CentralBody		 Moon
            CoordinateSystem		 J2000
            BEGIN SegmentBoundaryTimes
                 0.0000000000000000e+00
            END SegmentBoundaryTimes

            EphemerisTimePosVel		

         0.0000000000000000e+00  2.0e+06 0 0 1000 0 0
         6.0000000000000000e+01  2.06e+06 1.0e3 0 1000 33.3 0
         1.2000000000000000e+02  2.12e+06 4.0e3 0 1000 66.7 0
         1.8000000000000000e+02  2.18e+06 9.0e3 0 1000 100 0


        END Ephemeris

        """;

    private const string Rule = "*******************************************************************************\n";

    /// <summary>As STK 12 writes it: metres where no unit is given, tabs, comments, a section that is left out.</summary>
    [Fact]
    public void Read_Stk_GivesStatesInMetres()
    {
        TrajectoryBlock block = Assert.Single(Read(Stk));

        Assert.Equal(301, block.Center);
        Assert.Null(block.MoonMeFromFrame);
        Assert.Equal(4, block.Samples.Count);
        Assert.Equal(CcsdsTexts.Noon, block.Samples.Times.First.Seconds, OfTime);
        Assert.Equal(180.0, block.Samples.Times.Last - block.Samples.Times.First, OfTime);
        Assert.Equal(new Interpolation(InterpolationMethod.Lagrange, 3), block.Samples.Interpolation);

        // y is the minute squared in km: 2.25 at 1.5 minutes.
        Assert.InRange((block.Samples.At(CcsdsTexts.Noon + 90.0).Position - new Vector3D(2.09e6, 2250.0, 0.0)).Length, 0.0, 1e-3);
    }

    [Theory]
    [InlineData("CentralBody\t\t Moon", "CentralBody Luna", 301)]
    [InlineData("CentralBody\t\t Moon", "CentralBody Earth", 399)]
    [InlineData("CoordinateSystem\t\t J2000", "CoordinateSystem ICRF", 301)]
    [InlineData("19 Jan 2024 12:00:00.000000", "\"19 Jan 2024 12:00:00.000\"", 301)]
    [InlineData("stk.v.12.0", "stk.v.4.3", 301)]
    public void Read_StkInOtherWords_IsRead(string old, string text, int center) =>
        Assert.Equal(center, Assert.Single(Read(Stk.Replace(old, text, StringComparison.Ordinal))).Center);

    [Theory]
    [InlineData("Kilometers", 1000.0)]
    [InlineData("Meters", 1.0)]
    [InlineData("Feet", 0.3048)]
    public void Read_StkUnit_IsTaken(string unit, double metres)
    {
        string text = Stk.Replace("CentralBody", $"DistanceUnit {unit}\n    CentralBody", StringComparison.Ordinal);

        Assert.Equal(2.0e6 * metres, Assert.Single(Read(text)).Samples[0].Position.X, 1e-6);
    }

    /// <summary>Positions only; accelerations; the Moon's own axes.</summary>
    [Fact]
    public void Read_StkSections_AreRead()
    {
        string positions = Stk.Replace("TimePosVel", "TimePos", StringComparison.Ordinal)
            .Replace(" 1000 0 0\n", "\n", StringComparison.Ordinal)
            .Replace(" 1000 33.3 0\n", "\n", StringComparison.Ordinal).Replace(" 1000 66.7 0\n", "\n", StringComparison.Ordinal)
            .Replace(" 1000 100 0\n", "\n", StringComparison.Ordinal);
        Assert.False(Assert.Single(Read(positions)).Samples.HasVelocities);
        string accelerations = Stk.Replace("TimePosVel", "TimePosVelAcc", StringComparison.Ordinal)
            .Replace(" 0\n", " 0 0.1 0.2 0.3\n", StringComparison.Ordinal);
        Assert.Equal(1000.0, Assert.Single(Read(accelerations)).Samples[0].Velocity.X);
        Assert.Equal(
            RotationMatrix.Identity,
            Assert.Single(Read(Stk.Replace("J2000", "MeanEarth", StringComparison.Ordinal))).MoonMeFromFrame);
    }

    /// <summary>At a manoeuvre a time stands twice, with another velocity: nothing is interpolated across it.</summary>
    [Fact]
    public void Read_StkManoeuvre_PartsTheFile()
    {
        string text = Stk.Replace(
            " 1.2000000000000000e+02", " 6.0000000000000000e+01  2.06e+06 1.0e3 0 1100 33.3 0\n 1.2000000000000000e+02",
                StringComparison.Ordinal);

        IReadOnlyList<TrajectoryBlock> blocks = Read(text);

        Assert.Equal([2, 3], blocks.Select(block => block.Samples.Count));
        Assert.Equal(1100.0, blocks[1].Samples[0].Velocity.X);
    }

    [Theory]
    [InlineData("CoordinateSystem\t\t J2000", "CoordinateSystem Fixed",
        "o.e, line 16: CoordinateSystem 'Fixed' is not read; ICRF, J2000, MeanEarth, PrincipalAxes_421 are.")]
    [InlineData("CoordinateSystem\t\t J2000", "CoordinateSystem TEME", "o.e, line 16: CoordinateSystem 'TEME' is not read")]
    [InlineData("CentralBody\t\t Moon", "CentralBody Mars", "o.e, line 15: CentralBody 'Mars' is not read; Moon, Luna, Earth are.")]
    [InlineData("CentralBody\t\t Moon", "DistanceUnit Furlongs", "o.e, line 15: DistanceUnit 'Furlongs' is not read")]
    [InlineData("EphemerisTimePosVel", "EphemerisLLATimePosVel", "o.e, line 21: 'EphemerisLLATimePosVel' is not read")]
    [InlineData("19 Jan 2024", "31 Feb 2024", "o.e, line 9: ScenarioEpoch '31 Feb 2024 12:00:00.000000' is not a time")]
    [InlineData(" 1.2000000000000000e+02", " 3.0e+01", "o.e, line 25: the time is before that of the line above")]
    [InlineData(" 1000 66.7 0\n", " 1000\n", "o.e, line 25: 5 numbers; 7 are needed")]
    public void Read_WrongStk_IsNamedByLine(string old, string text, string beginning) => Assert.StartsWith(
        beginning, Assert.Throws<BadInputException>(() => Read(Stk.Replace(old, text, StringComparison.Ordinal))).Message,
        StringComparison.Ordinal);

    /// <summary>
    /// The vector of a state in each frame: the ecliptic's (1, 2, 3) is (1, 0.64163, 3.54800) of the equator, by rotating about x by
    /// 84381.448 arcsec: python3 -c "from math import *; e=radians(84381.448/3600); print(2*cos(e)-3*sin(e), 2*sin(e)+3*cos(e))".
    /// </summary>
    [Theory]
    [InlineData("Reference frame : Ecliptic of J2000.0", 0.6416326563426225, 3.5480004980713726)]
    [InlineData("Reference frame : ICRF", 2.0, 3.0)]
    [InlineData("Reference frame : ICRF/J2000.0\nCoordinate systm: Ecliptic and Mean Equinox of Reference Epoch",
        0.6416326563426225, 3.5480004980713726)]
    [InlineData("Reference frame : ICRF/J2000.0\nCoordinate systm: Earth Mean Equator and Equinox of Reference Epoch", 2.0, 3.0)]
    public void Read_HorizonsFrame_IsTurnedToTheEquator(string frame, double y, double z)
    {
        StateVector state = Assert.Single(Read(Horizons(frame: frame))).Samples[0];

        Assert.InRange((state.Position - new Vector3D(1e6, y * 1e6, z * 1e6)).Length, 0.0, 1e-5);
        Assert.InRange((state.Velocity - new Vector3D(100.0, y * 100.0, z * 100.0)).Length, 0.0, 1e-9);
    }

    /// <summary>au and days: 1 au is 149,597,870,700 m by definition.</summary>
    [Theory]
    [InlineData("KM-S", 1000.0, 1000.0)]
    [InlineData("AU-D", 149_597_870_700.0, 149_597_870_700.0 / 86400.0)]
    [InlineData("KM-D", 1000.0, 1000.0 / 86400.0)]
    public void Read_HorizonsUnits_AreTaken(string units, double metres, double metresPerSecond)
    {
        StateVector state = Assert.Single(Read(Horizons(units: units))).Samples[0];

        Assert.Equal(1000.0 * metres, state.Position.X, 1e-4);
        Assert.Equal(0.1 * metresPerSecond, state.Velocity.X, 1e-6);
    }

    [Theory]
    [InlineData(" X = 1.000000000000000E+03 Y = 2.000000000000000E+03 Z = 3.000000000000000E+03\n"
            + " VX= 1.000000000000000E-01 VY= 2.000000000000000E-01 VZ= 3.000000000000000E-01\n"
            + " LT= 6.1E-03 RG= 1.8E+03 RR= 1.0E-02\n", "3 (position, velocity, LT, range, range-rate)")]
    [InlineData("   1.000000000000000E+03  2.000000000000000E+03  3.000000000000000E+03\n"
            + "   1.000000000000000E-01  2.000000000000000E-01  3.000000000000000E-01\n   6.1E-03  1.8E+03 1.0E-02\n",
        "3 (position, velocity, LT, range, range-rate)")]
    [InlineData(" X = 1.000000000000000E+03 Y = 2.000000000000000E+03 Z = 3.000000000000000E+03\n"
            + " VX= 1.000000000000000E-01 VY= 2.000000000000000E-01 VZ= 3.000000000000000E-01\n", "2 (position and velocity)")]
    public void Read_HorizonsLayouts_GiveTheSame(string state, string format)
    {
        TrajectoryBlock block = Assert.Single(Read(Horizons(state: state, format: format)));

        Assert.Equal(301, block.Center);
        Assert.Equal(2, block.Samples.Count);
        Assert.Equal(new StateVector(new Vector3D(1e6, 2e6, 3e6), new Vector3D(100.0, 200.0, 300.0)), block.Samples[1]);

        // 2026-01-01T00:00 TDB is 9496.5 days past J2000 (JD 2461041.5).
        Assert.Equal(9496.5 * 86400.0, block.Samples.Times.First.Seconds, 1e-6);
        Assert.Equal(60.0, block.Samples.Times.Last - block.Samples.Times.First, 1e-6); // not the 59.9999616 of the rounded Julian date
    }

    /// <summary>As the API gives CSV, with and without labels, and with del_T of other time types.</summary>
    [Fact]
    public void Read_HorizonsCsv_GivesTheSame()
    {
        string text = Horizons().Split("$$SOE")[0].Replace("JDTDB\n",
            "JDTDB,            Calendar Date (TDB),      X,      Y,      Z,     VX,     VY,     VZ,\n", StringComparison.Ordinal)
            + "$$SOE\n2461041.500000000, A.D. 2026-Jan-01 00:00:00.0000,  1.000000000000000E+03,  "
                    + "2.000000000000000E+03,  3.000000000000000E+03,  1.000000000000000E-01,  2.000000000000000E-01,  "
                    + "3.000000000000000E-01,\n$$EOE\n";

        Assert.Equal(
            new StateVector(new Vector3D(1e6, 2e6, 3e6), new Vector3D(100.0, 200.0, 300.0)), Assert.Single(Read(text)).Samples[0]);
    }

    [Theory]
    [InlineData("Moon (301)", "Earth (399)", "o.e, line 4: Center body name: 'Earth (399)'; the Moon is needed: CENTER='500@301'.")]
    [InlineData("GEOMETRIC cartesian states", "LT+S cartesian states",
        "o.e, line 9: Output type: 'LT+S cartesian states'; geometric states")]
    [InlineData("3 (position, velocity, LT, range, range-rate)", "4 (LT, range, range-rate)",
        "o.e, line 10: Output format: '4 (LT, range, range-rate)'; 1 (position), 2 and 3")]
    [InlineData("Reference frame : ICRF", "Reference frame : FK4/B1950", "o.e, line 11: Reference frame: 'FK4/B1950'; ICRF, the ecliptic")]
    [InlineData("A.D. 2026-Jan-01 00:00:00.0000 TDB\nStop", "A.D. 2026-Jan-01 00:00:00.0000 UT\nStop", "o.e, line 6: Start time: ")]
    [InlineData("$$EOE\n", "", "o.e, line 23: the file ends before the line $$EOE")]
    [InlineData("BODY CENTER", "Shackleton", "o.e, line 5: Center-site name: 'Shackleton'; BODY CENTER is needed")]
    public void Read_OtherHorizons_IsRefusedByName(string old, string text, string beginning) => Assert.StartsWith(
        beginning, Assert.Throws<BadInputException>(() => Read(Horizons().Replace(old, text, StringComparison.Ordinal))).Message,
        StringComparison.Ordinal);

    /// <summary>Files that are given as trajectories and are something else.</summary>
    [Theory]
    [InlineData("<?xml version=\"1.0\"?>\n<gpx version=\"1.1\">", "a GPX track")]
    [InlineData("ISS (ZARYA)\n1 25544U 98067A   08264.51782528 -.00002182  00000-0 -11606-4 0  2927\n"
            + "2 25544  51.6416 247.4627 0006703 130.5360 325.0288 15.72125391563537\n", "a TLE")]
    [InlineData("DAF/SPK ", "an SPK kernel of SPICE")]
    [InlineData("%General Mission Analysis Tool(GMAT) Script\nCreate Spacecraft Sat;\n", "a script of GMAT")]
    [InlineData("stk.v.11.0\nBEGIN Attitude\nNumberOfAttitudePoints 3\n", "an attitude file of STK")]
    [InlineData("#dP2020  6 24  0  0  0.00000000      96 ORBIT IGS14", "an SP3 file")]
    public void Of_KnownFormat_IsNamed(string text, string name) => Assert.StartsWith(
        $"this is {name}", KnownFormats.Of(System.Text.Encoding.Latin1.GetBytes(text))!.Refusal(FormatUse.Trajectory),
        StringComparison.Ordinal);

    private static string Horizons(
        string frame = "Reference frame : ICRF", string units = "KM-S", string? state = null,
        string format = "3 (position, velocity, LT, range, range-rate)")
    {
        string vectors = state ?? " X = 1.000000000000000E+03 Y = 2.000000000000000E+03 Z = 3.000000000000000E+03\n"
            + " VX= 1.000000000000000E-01 VY= 2.000000000000000E-01 VZ= 3.000000000000000E-01\n LT= 6.1E-03 RG= 1.8E+03 RR= 1.0E-02\n";
        return "API VERSION: 1.2\n" + Rule + "Target body name: Danuri (spacecraft) (-155)      {source: kplo}\n"
            + "Center body name: Moon (301)                      {source: DE441}\nCenter-site name: BODY CENTER\n"
            + "Start time      : A.D. 2026-Jan-01 00:00:00.0000 TDB\nStop  time      : A.D. 2026-Jan-01 00:01:00.0000 TDB\n"
            + $"Output units    : {units}                                      \nOutput type     : GEOMETRIC cartesian states\n"
            + $"Output format   : {format}\n{frame}\n{Rule}JDTDB\n$$SOE\n"
            + $"2461041.500000000 = A.D. 2026-Jan-01 00:00:00.0000 TDB \n{vectors}"
            + $"2461041.500694444 = A.D. 2026-Jan-01 00:01:00.0000 TDB [del_T=     69.183912 s]\n{vectors}$$EOE\n" + Rule;
    }

    private static IReadOnlyList<TrajectoryBlock> Read(string text)
    {
        using StringReader reader = new(text);
        TrajectoryReading reading = new(
            new BoundedLineReader(reader, "o.e"), new CcsdsPlace("o.e"), CcsdsTexts.Scale, () => RotationMatrix.FrameAboutX(1e-3));
        return StkEphemeris.Head.IsMatch(text) ? new StkEphemeris(reading).Read()
            : HorizonsVectors.Head.IsMatch(text) ? new HorizonsVectors(reading).Read()
            : throw new ArgumentException("neither STK nor Horizons", nameof(text));
    }
}
