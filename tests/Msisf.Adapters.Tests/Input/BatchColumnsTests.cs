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
    internal const string FileName = "input/run7.csv";
    internal const string Quaternion = "0.1,0.2,0.3,0.9273618495495703";

    [Fact]
    public void Read_EightColumns_IsTheStateOfTheThesis()
    {
        SpacecraftState expected = Moments.StateOf([60328.5, 2e6, 1.0, -3.0, 0.1, 0.2, 0.3, 0.9273618495495703]);

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
            SpacecraftState[] written = [.. states.Select(state => Moments.StateOf([.. state.ToNumbers(), .. motion]) with
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
        Assert.Equal(0.0, (up[0] + Vector3D.UnitZ).Length, Rounding.OfChains);
        Assert.Equal(0.0, (up[1] - Vector3D.UnitY).Length, Rounding.OfChains);
    }

    [Fact]
    public void Read_Motion_IsThatOfTheState()
    {
        double[] numbers = [60328.5, 2e6, 1.0, -3.0, 0.1, 0.2, 0.3, 0.9273618495495703, 1500.0, -2.0, 3.5, 1e-3, 0.0, -2e-4];
        SpacecraftState expected = Moments.StateOf(numbers);
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
        Assert.Equal(
            MoonConstants.ReferenceRadius + SphereScene.TerrainHeight + 50_000.0, state.PositionBodyFixed.Length,
            Rounding.OfConvertedPlaces);
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

        BatchFileReader.Read(reader, FileName, new SphereScene(), warn: warnings.Add);

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
            reader, FileName, new SphereScene(), new BatchConventions { IgnoresColumns = true }, warnings.Add, notes.Add);

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
    public void Read_OnlyHeader_NoState() => Assert.Empty(Read("time,x,y,z\n"));

    internal static IReadOnlyList<SpacecraftState> Read(string text)
    {
        using StringReader reader = new(text);
        return BatchFileReader.Read(reader, FileName, new SphereScene());
    }

    private static void AssertLooks(Vector3D expected, string text)
    {
        Vector3D forward = Assert.Single(Read(text)).MoonFromCamera * -Vector3D.UnitX;
        Assert.InRange((forward - expected).Length, 0.0, 1e-15); // some ulps of 1, 2.2e-16: a normalisation and a rotation
    }
}
