using Msisf.Adapters.Input;
using Msisf.Core.Attitude;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Scene;
using Msisf.Core.Terrain;
using Msisf.TestSupport;
using Xunit;

using Msisf.Core.Surface.Sources;

namespace Msisf.Adapters.Tests.Input;

/// <summary>Batch files whose first line names their columns.</summary>
public class BatchColumnsTests
{
    private const string File = "input/run7.csv";
    private const string Quaternion = "0.1,0.2,0.3,0.9273618495495703";

    [Fact]
    public void Read_EightColumns_IsTheStateOfTheThesis()
    {
        SpacecraftState expected = SpacecraftState.FromNumbers([60328.5, 2e6, 1.0, -3.0, 0.1, 0.2, 0.3, 0.9273618495495703]);

        Assert.Equal([expected], Read($"time,x,y,z,qx,qy,qz,qw\n2024-01-19T12:00:00Z,2E6,1,-3,{Quaternion}"));
        Assert.Equal([expected], Read($"MJD,rx,ry,rz,qx,qy,qz,q0\n60328.5,2E6,1,-3,{Quaternion}"));
        Assert.Equal([expected], Read(
            $"# flight\r\n\r\n Time , X,Y,Z,QX,QY,QZ,QW # names\r\n 60328.5 ,2E6, 1,-3,{Quaternion} # 1\r\n#end"));
        Assert.Equal([expected], Read($"z,y,x,time,qw,qx,qy,qz\n-3,1,2E6,60328.5,0.9273618495495703,0.1,0.2,0.3"));
    }

    /// <summary>A seed alone goes with the number of its line; what is written is read back, beside a motion too.</summary>
    [Fact]
    public void Read_NoiseSeed_GoesWithTheNumberOfTheState()
    {
        IReadOnlyList<SpacecraftState> states = Read(
            $"time,x,y,z,qx,qy,qz,qw,noise_seed\n60328.5,2E6,1,-3,{Quaternion},18446744073709551615\n# comment\n\n"
                + $"60328.5,2E6,1,-3,{Quaternion},7\n60328.5,2E6,1,-3,{Quaternion},7:40");

        Assert.Equal(
            [new NoiseSeed(ulong.MaxValue, 1), new NoiseSeed(7, 2), new NoiseSeed(7, 40)], states.Select(state => state.Noise!.Value));
        foreach (double[] motion in (double[][])[[], [1.0, 2.0, 3.0, 0.1, 0.2, 0.3]])
        {
            SpacecraftState[] written = [.. states.Select(state => SpacecraftState.FromNumbers([.. state.ToNumbers(), .. motion]) with
            {
                Noise = state.Noise,
            })];
            StringWriter writer = new();
            BatchFileWriter.Write(writer, "head", written);
            Assert.Equal(written, Read(writer.ToString()));
        }
    }

    /// <summary>The Sun's columns stand anywhere, in the file's frame; what is written is read back, beside motion and noise too.</summary>
    [Fact]
    public void Read_Sun_IsThatOfTheState()
    {
        SpacecraftState[] states = [.. Read(
            $"sun_z,time,x,y,z,sun_x,qx,qy,qz,qw,SUN_Y\n-3E9,60328.5,2E6,1,-3,1.4E11,{Quaternion},2.5E10\n"
                + $"0,60328.5,2E6,1,-3,-1.5E11,{Quaternion},1")];

        Assert.Equal(
            [new Vector3D(1.4e11, 2.5e10, -3e9), new Vector3D(-1.5e11, 1.0, 0.0)],
                states.Select(state => state.SunPositionBodyFixed!.Value));
        foreach (bool hasNoise in (bool[])[false, true])
        {
            SpacecraftState[] written = [.. states.Select(state => state with { Noise = hasNoise ? new NoiseSeed(7, 3) : null })];
            StringWriter writer = new();
            BatchFileWriter.Write(writer, "head", written);
            Assert.Equal(written, Read(writer.ToString()));
        }
    }

    /// <summary>Each line's own Sun is what is above in its image.</summary>
    [Fact]
    public void Read_SunAndUpSun_AreTheSameSun()
    {
        SpacecraftState[] states = [.. Read(
            "time,x,y,z,off_nadir,up,sun_x,sun_y,sun_z\n60328.5,2E6,0,0,0,sun,1.4E11,0,-1E10\n60328.5,2E6,0,0,0,sun,1E10,1.4E11,0")];

        Vector3D[] up = [.. states.Select(state => state.MoonFromCamera * Vector3D.UnitZ)];
        Assert.Equal(0.0, (up[0] + Vector3D.UnitZ).Length, 1e-12);
        Assert.Equal(0.0, (up[1] - Vector3D.UnitY).Length, 1e-12);
    }

    [Theory]
    [InlineData("sun_x,sun_y,sun_z", "1,0,0", "metres are needed")]
    [InlineData("sun_x,sun_y,sun_z", "1.5E8,0,0", "metres are needed")]
    [InlineData("sun_x,sun_y,sun_z", "1.5E11,NaN,0", "sun_y")]
    [InlineData("sun_x,sun_y", "1.5E11,0", "sun_z")]
    public void Read_SunThatIsNone_IsRefused(string names, string values, string expected)
    {
        BadInputException exception = Assert.Throws<BadInputException>(
            () => Read($"time,x,y,z,qx,qy,qz,qw,{names}\n60328.5,2E6,1,-3,{Quaternion},{values}"));

        Assert.Contains(expected, exception.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("-1")]
    [InlineData("1.5")]
    [InlineData("")]
    [InlineData("18446744073709551616")]
    [InlineData("1:")]
    [InlineData("1:2:3")]
    public void Read_WrongNoiseSeed_IsNamedByLineAndColumn(string seed)
    {
        BadInputException error = Assert.Throws<BadInputException>(
            () => Read($"time,x,y,z,qx,qy,qz,qw,noise_seed\n60328.5,2E6,1,-3,{Quaternion},{seed}"));

        Assert.StartsWith(
            $"{File}, line 2, column noise_seed: '{seed}' is no noise seed; a whole number from 0 on",
            error.Message,
            StringComparison.Ordinal);
    }

    [Fact]
    public void Read_Motion_IsThatOfTheState()
    {
        double[] numbers = [60328.5, 2e6, 1.0, -3.0, 0.1, 0.2, 0.3, 0.9273618495495703, 1500.0, -2.0, 3.5, 1e-3, 0.0, -2e-4];
        SpacecraftState expected = SpacecraftState.FromNumbers(numbers);
        Assert.Equal(1500.0, expected.Motion!.Value.VelocityBodyFixed.X);
        Assert.Equal(-2e-4, expected.Motion.Value.AngularVelocityCamera.Z);
        Assert.Equal(numbers, expected.ToNumbers());

        Assert.Equal([expected], Read(
            $"time,x,y,z,qx,qy,qz,qw,vx,vy,vz,wx,wy,wz\n60328.5,2E6,1,-3,{Quaternion},1500,-2,3.5,1e-3,0,-2e-4"));
        StringWriter writer = new();
        BatchFileWriter.Write(writer, "head", [expected]);
        Assert.Equal([expected], Read(writer.ToString()));
        Assert.Contains("# MJD rx ry rz qx qy qz q0 vx vy vz wx wy wz", writer.ToString(), StringComparison.Ordinal);
        Assert.Contains(
            "column wz is missing: vx, vy, vz, wx, wy, wz go together.",
            Assert.Throws<BadInputException>(() => Read("time,x,y,z,vx,vy,vz,wx,wy\n1,2,3,4,5,6,7,8,9")).Message,
            StringComparison.Ordinal);
    }

    [Fact]
    public void Read_PlaceAndTarget_AreThoseOfPointing()
    {
        SpacecraftState state = Assert.Single(Read(
            "time,lat,lon,height,look_lat,look_lon,roll,up\n60328.5,10,20,terrain+50000,11,21,30,north"));

        Vector3D position = new SurfacePlace(10.0, 20.0, 50_000.0, isOverTerrain: true).ToPositionBodyFixed(new SphereScene().GroundRadius);
        CameraPointing pointing = new()
        {
            Kind = BoresightKind.Place,
            Target = new SurfacePlace(11.0, 21.0, 0.0, isOverTerrain: true),
            Roll = Math.PI / 6.0,
            Up = UpDirection.North,
        };
        Assert.Equal(position, state.PositionBodyFixed);
        Assert.Equal(MoonConstants.ReferenceRadius + SphereScene.TerrainHeight + 50_000.0, state.PositionBodyFixed.Length, 1e-8);
        Assert.Equal(pointing.MoonFromCamera(position, state.Time, new SphereScene()), state.MoonFromCamera);
    }

    [Fact]
    public void Read_EachWayToPoint_LooksThere()
    {
        // From 0 N 0 E: nadir is -x, east y, north z.
        AssertLooks(new Vector3D(-1.0, 0.0, 0.0), "time,lat,lon,height\n60328.5,0,0,1E5");
        AssertLooks(new Vector3D(-1.0, 0.0, 0.0), "time,x,y,z\n60328.5,2E6,0,0");
        AssertLooks(new Vector3D(0.0, 0.0, 1.0), "time,x,y,z,off_nadir\n60328.5,2E6,0,0,90");
        AssertLooks(new Vector3D(0.0, 1.0, 0.0), "time,x,y,z,off_nadir,azimuth\n60328.5,2E6,0,0,90,90");
        AssertLooks(new Vector3D(-1.0, 0.0, 0.0), "time,x,y,z,look_lat,look_lon,look_height\n60328.5,2E6,0,0,0,0,-100");
    }

    [Theory]
    [InlineData(
        "time,lat,lon,hight\n",
        "input/run7.csv, line 1: column 4: 'hight' is no column: did you mean height? There are time, ")]
    [InlineData("#\n,time,lat\n", "input/run7.csv, line 2: column 1 has no name.")]
    [InlineData("time,lat,LAT\n", "input/run7.csv, line 1: column 3: 'LAT' stands twice.")]
    [InlineData("time;lat;lon\n", "input/run7.csv, line 1: columns and values are apart by commas, not by semicolons.")]
    [InlineData("lat,lon,height\n", "input/run7.csv, line 1: column time is missing")]
    [InlineData("time,lat,lon\n", "input/run7.csv, line 1: column height is missing: lat, lon, height go together.")]
    [InlineData("time,roll\n", "input/run7.csv, line 1: a position is either lat, lon and a height ")]
    [InlineData("time,x,y,z,lat,lon,height\n", "input/run7.csv, line 1: a position is either lat, lon and a height ")]
    [InlineData("time,x,y,z,qx,qy,qz\n", "input/run7.csv, line 1: column qw is missing: qx, qy, qz, qw go together.")]
    [InlineData("time,x,y,z,look_lat\n", "input/run7.csv, line 1: column look_lon is missing")]
    [InlineData("time,x,y,z,look_height\n", "input/run7.csv, line 1: column look_height needs look_lat.")]
    [InlineData("time,x,y,z,azimuth\n", "input/run7.csv, line 1: column azimuth needs off_nadir.")]
    [InlineData("time,x,y,z,look_lat,look_lon,off_nadir\n", "input/run7.csv, line 1: look_lat and off_nadir both say")]
    [InlineData(
        "time,x,y,z,qx,qy,qz,qw,roll\n",
        "input/run7.csv, line 1: qx, qy, qz, qw already say how the camera points. Remove them, or roll")]
    [InlineData("time,x,y,z\n1,2,3\n", "input/run7.csv, line 2: 3 values, 4 columns.")]
    [InlineData("time,x,y,z\n1,2,3,4\n1,2,3,4,5\n", "input/run7.csv, line 3: 5 values, 4 columns.")]
    [InlineData("time,x,y,z\n1,2,,4\n", "input/run7.csv, line 2, column y: a number is missing.")]
    [InlineData(
        "time,x,y,z\n2460329,2,3,4\n",
        "input/run7.csv, line 2, column time: '2460329' looks like a Julian Date; its MJD is 60328.5")]
    [InlineData("time,x,y,z\n1e9,2,3,4\n", "input/run7.csv, line 2, column time: The MJD 1000000000 is not a date")]
    [InlineData("time,lat,lon,height\n1,2,3,terain\n", "input/run7.csv, line 2, column height: 'terain' is no height; write ")]
    [InlineData("time,lat,lon,height\n1,120,30,5\n", "input/run7.csv, line 2: The latitude (degrees) is 120; ")]
    [InlineData("time,x,y,z,up\n1,2,3,4,left\n", "input/run7.csv, line 2, column up: 'left' is not up; zenith, north or sun is needed.")]
    [InlineData("time,x,y,z,off_nadir\n1,2,3,4,200\n", "input/run7.csv, line 2: The angle from the nadir (degrees) is 200")]
    [InlineData("time,x,y,z,qx,qy,qz,qw\n1,2E6,3,4,0,0,0,0.9\n", "input/run7.csv, line 2: The quaternion {0,0,0,0.9} has length 0.9")]
    [InlineData("time,x,y,z\n1,0,0,0\n", "input/run7.csv, line 2: The spacecraft is in the Moon's centre")]
    [InlineData("time,x,y,z,speed\n", "input/run7.csv, line 1: column 5: 'speed' is no column. There are time, seconds, ")]
    [InlineData("time,x,y,z,q1,q2,q3,q4\n", "input/run7.csv, line 1: column 8: of q1 to q4 some programs mean q4 as the scalar")]
    [InlineData("time,x,y,z,qw,qx,qy,qz,q0\n", "input/run7.csv, line 1: column 9: 'q0' stands twice, as qw too.")]
    [InlineData("time,lat,lon,height,alt\n", "input/run7.csv, line 1: height and alt all say how high the camera is.")]
    [InlineData("time,x,y,z,height\n", "input/run7.csv, line 1: a position is either ")]
    [InlineData("time,x,y,z,x_km,y_km,z_km\n", "input/run7.csv, line 1: a position is either ")]
    [InlineData("time,seconds,x,y,z\n", "input/run7.csv, line 1: time and seconds both say when.")]
    [InlineData("seconds,x,y,z\n", "input/run7.csv, line 1: column seconds needs the epoch from which they count: --epoch, or ")]
    [InlineData("time,x,y,z,r11,r12\n", "input/run7.csv, line 1: column r13 is missing: r11, r12, ")]
    [InlineData("time,x,y,z,euler1,euler2,euler3\n", "input/run7.csv, line 1: Euler angles need their sequence: ")]
    [InlineData(
        "#msis:euler=ZYX\ntime,x,y,z,euler1,euler2,euler3,qx,qy,qz,qw\n", "input/run7.csv, line 2: qx, qy, qz, qw already say how")]
    [InlineData(
        "time,x,y,z,r11,r12,r13,r21,r22,r23,r31,r32,r33\n1,2E6,0,0,1,0,0,0,1,0,0,0,-1\n",
        "input/run7.csv, line 2: The matrix is a reflection (its determinant is -1)")]
    [InlineData(
        "time,x,y,z,r11,r12,r13,r21,r22,r23,r31,r32,r33\n1,2E6,0,0,1,0,0,0,1,0,0,0,0.9999\n",
        "input/run7.csv, line 2: The matrix is no rotation: the products of its rows are wrong by up to 0.0002, 1E-06 is allowed: write")]
    [InlineData(
        "time,x,y,z,r11,r12,r13,r21,r22,r23,r31,r32,r33\n1,2E6,0,0,1,0,0,0,1,0,0.5,0,1\n",
        "input/run7.csv, line 2: The matrix is no rotation: the products of its rows are wrong by up to 0.5, 1E-06 is allowed: rounding")]
    [InlineData("time,rx,ry,rz,q0,q1,q2,q3\n1,2,3,4,5,x,6,7\n", "input/run7.csv, line 2, column q1: 'x' is not a number")]
    [InlineData("# msis: fram=j2000\n", "input/run7.csv, line 1: 'fram' is no key of a '# msis:' line: did you mean frame?")]
    [InlineData("# msis: frame\n", "input/run7.csv, line 1: 'frame' has no value; write frame=VALUE, without blanks.")]
    [InlineData(
        "#\n# MSIS: Frame=moon_pa\n",
        "input/run7.csv, line 2: 'frame' is 'moon_pa'; one of moon-me, moon-me-epoch, j2000 is needed.")]
    [InlineData("#msis: frame=j2000 frame=j2000\n", "input/run7.csv, line 1: 'frame' is said twice: here, and before or by --batch-")]
    [InlineData("# msis: euler=zyx\n", "input/run7.csv, line 1: 'zyx' in small letters means turns about axes at rest in some")]
    [InlineData("# msis: euler=XXY\n", "input/run7.csv, line 1: 'XXY' is no sequence of Euler angles; three axes such as ZYX")]
    [InlineData("# msis: epoch=2460329\n", "input/run7.csv, line 1: '2460329' looks like a Julian Date")]
    [InlineData("time,x,y,z # msis: frame=j2000\n", "input/run7.csv, line 1: a '# msis:' line stands by itself, above the names")]
    [InlineData("time,x,y,z\n# msis: frame=j2000\n", "input/run7.csv, line 2: a '# msis:' line stands by itself, above the names")]
    [InlineData("1 2E6 0 0 0 0 0 1\n# msis: frame=j2000\n", "input/run7.csv, line 2: a '# msis:' line stands by itself")]
    [InlineData("#msis: frame=j2000\ntime,lat,lon,height\n", "input/run7.csv, line 2: 'frame' has no meaning: no column is of a frame.")]
    [InlineData("# msis: axes=opencv\ntime,x,y,z\n", "input/run7.csv, line 2: 'axes' has no meaning: no quaternion, matrix or Euler angle")]
    [InlineData("# msis: rotation=to-camera\ntime,x,y,z\n", "input/run7.csv, line 2: 'rotation' has no meaning: there is no quaternion")]
    [InlineData("# msis: euler=321\n1 2E6 0 0 0 0 0 1\n", "input/run7.csv, line 2: 'euler' has no meaning: there are no columns euler1")]
    [InlineData("# msis: epoch=55289\ntime,x,y,z\n", "input/run7.csv, line 2: the epoch has no meaning: there is no column seconds")]
    [InlineData("# msis: frame=moon-me-epoch\ntime,x,y,z\n", "input/run7.csv, line 2: frame moon-me-epoch needs the epoch")]
    [InlineData(
        "# msis: frame=j2000\ntime,x,y,z,vx,vy,vz,wx,wy,wz\n",
        "input/run7.csv, line 2: vx, vy, vz, wx, wy, wz are those over the turning Moon, in frame moon-me only.")]
    [InlineData(
        "# msis: frame=j2000\n1 2E6 0 0 0 0 0 1 1 1 1 1 1 1\n",
        "input/run7.csv, line 2: vx, vy, vz, wx, wy, wz are those over the turning Moon, in frame moon-me only.")]
    public void Read_Wrong_NamesLineAndColumn(string text, string message) =>
        Assert.StartsWith(message, Assert.Throws<BadInputException>(() => Read(text)).Message, StringComparison.Ordinal);

    [Fact]
    public void Read_CommasWithoutHeader_SaysThatOneIsNeeded() => Assert.EndsWith(
        "Values apart by commas need a header line, e.g. time,lat,lon,height.",
        Assert.Throws<BadInputException>(() => Read("55289,2E6,2E6,0,0,0,0,1")).Message,
        StringComparison.Ordinal);

    [Theory]
    [InlineData("time lat lon height\n55289 1 2 3")]
    [InlineData("MJD\trx\try\trz\tqx\tqy\tqz\tq0\n55289\t2E6\t0\t0\t0\t0\t0\t1")]
    public void Read_HeaderWithoutCommas_SaysThatTheyAreNeeded(string text) => Assert.EndsWith(
        "Names of columns, and their values, are apart by commas, e.g. time,lat,lon,height.",
        Assert.Throws<BadInputException>(() => Read(text)).Message,
        StringComparison.Ordinal);

    [Fact]
    public void Read_QuotedFields_AreThoseWithoutQuotes() => Assert.Equal(
        Read("time,lat,lon,height\n60328.5,1,2,3E4"), Read("\"time\",\"lat\", \"lon\",height\n\"60328.5\",\"1\",2, \"3E4\""));

    [Theory]
    [InlineData("60328.5,0,0,1E5,0,20\n60328.5,0,0,1E5,0,1\n60328.5,0,0,1E5,0,180", " So it is in 1 more line.")]
    [InlineData("60328.5,0,0,1E5,0,20\n60328.5,0,0,1E5,0,1", " Are latitude (first) and longitude (east) what you mean?")]
    public void Read_TargetBeyondTheHorizon_WarnsOnceByLine(string lines, string end)
    {
        using StringReader reader = new($"time,lat,lon,height,look_lat,look_lon\n{lines}");
        List<string> warnings = [];

        BatchFileReader.Read(reader, File, new SphereScene(), warn: warnings.Add);

        Assert.StartsWith(
            "input/run7.csv, line 2: the place to look at lies behind ground", Assert.Single(warnings), StringComparison.Ordinal);
        Assert.EndsWith(end, warnings[0], StringComparison.Ordinal);
    }

    [Fact]
    public void Read_WhatMayBeMeantOtherwise_IsSaidOnce()
    {
        List<string> notes = [];
        List<string> warnings = [];
        using StringReader reader = new(
            "# msis: euler=ZYX\ntime,lat,lon,alt,euler1,euler2,euler3,vx,vy,vz,fuel,\n"
                + "60328.5,0,0,1E5,1.5,-3.1,0,1600,0,0,7,\n60328.6,0,0,1E5,1.5,-3.1,0,1600,0,0,6,\n");

        IReadOnlyList<SpacecraftState> states = BatchFileReader.Read(
            reader, File, new SphereScene(), new BatchConventions { IgnoresColumns = true }, warnings.Add, notes.Add);

        Assert.Equal(2, states.Count);
        Assert.All(states, state => Assert.Null(state.Motion));
        Assert.Equal(
            [
                "input/run7.csv: left out, as --ignore-columns says: 'fuel', ''.",
                "input/run7.csv: column alt is taken as m over the sphere of 1737400 m; height takes terrain+m, height_km kilometres.",
                "input/run7.csv: the velocity vx, vy, vz is not used: an image has no motion without wx, wy, wz and a camera with a "
                    + "shutter.",
            ],
            notes);
        Assert.Equal(
            "input/run7.csv: Euler angles are in degrees; none is above 3.1. If they are radians, convert them.", Assert.Single(warnings));
    }

    [Fact]
    public void Read_IgnoredColumnsWithoutNames_IsRefused()
    {
        using StringReader reader = new("60328.5 2E6 0 0 0 0 0 1");

        Assert.StartsWith(
            "input/run7.csv, line 1: --ignore-columns has no meaning: the file names no columns.",
            Assert.Throws<BadInputException>(() => BatchFileReader.Read(
                reader, File, new SphereScene(), new BatchConventions { IgnoresColumns = true })).Message,
            StringComparison.Ordinal);
    }

    [Fact]
    public void Read_OnlyHeader_NoState() => Assert.Empty(Read("time,x,y,z\n"));

    private static IReadOnlyList<SpacecraftState> Read(string text)
    {
        using StringReader reader = new(text);
        return BatchFileReader.Read(reader, File, new SphereScene());
    }

    private static void AssertLooks(Vector3D expected, string text)
    {
        Vector3D forward = Assert.Single(Read(text)).MoonFromCamera * -Vector3D.UnitX;
        Assert.InRange((forward - expected).Length, 0.0, 1e-15); // some ulps of 1, 2.2e-16: a normalisation and a rotation
    }
}
