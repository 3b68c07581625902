using Msisf.Adapters.Input;
using Msisf.Core.Errors;
using Msisf.TestSupport;
using Xunit;
using static Msisf.Adapters.Tests.Input.BatchColumnsTests;

namespace Msisf.Adapters.Tests.Input;

/// <summary>What is said of batch files whose columns or values are wrong.</summary>
public class BatchColumnErrorsTests
{
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
            $"{FileName}, line 2, column noise_seed: '{seed}' is not a noise seed; a whole number from 0 on",
            error.Message,
            StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(
        "time,lat,lon,hight\n",
        "input/run7.csv, line 1: column 4: 'hight' is not a column: did you mean height? There are time, ")]
    [InlineData("#\n,time,lat\n", "input/run7.csv, line 2: column 1 has no name.")]
    [InlineData("time,lat,LAT\n", "input/run7.csv, line 1: column 3: 'LAT' occurs twice.")]
    [InlineData("time;lat;lon\n", "input/run7.csv, line 1: columns and values are apart by commas, not by semicolons.")]
    [InlineData("lat,lon,height\n", "input/run7.csv, line 1: column time is missing")]
    [InlineData("time,lat,lon\n", "input/run7.csv, line 1: column height is missing: lat, lon, height go together.")]
    [InlineData("time,roll\n", "input/run7.csv, line 1: a position is either lat, lon (or the name of a place) and a height ")]
    [InlineData(
        "time,x,y,z,lat,lon,height\n", "input/run7.csv, line 1: a position is either lat, lon (or the name of a place) and a height ")]
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
    [InlineData("time,lat,lon,height\n1,2,3,terain\n", "input/run7.csv, line 2, column height: 'terain' is not a height; write ")]
    [InlineData("time,lat,lon,height\n1,120,30,5\n", "input/run7.csv, line 2: The latitude (degrees) is 120; ")]
    [InlineData("time,x,y,z,up\n1,2,3,4,left\n", "input/run7.csv, line 2, column up: 'left' is not up; zenith, north or sun is needed.")]
    [InlineData("time,x,y,z,off_nadir\n1,2,3,4,200\n", "input/run7.csv, line 2: The angle from the nadir (degrees) is 200")]
    [InlineData("time,x,y,z,qx,qy,qz,qw\n1,2E6,3,4,0,0,0,0.9\n", "input/run7.csv, line 2: The quaternion {0,0,0,0.9} has length 0.9")]
    [InlineData("time,x,y,z\n1,0,0,0\n", "input/run7.csv, line 2: The spacecraft is in the Moon's centre")]
    [InlineData("time,x,y,z,speed\n", "input/run7.csv, line 1: column 5: 'speed' is not a column. There are time, seconds, ")]
    [InlineData("time,x,y,z,q1,q2,q3,q4\n", "input/run7.csv, line 1: column 8: of q1 to q4 some programs mean q4 as the scalar")]
    [InlineData("time,x,y,z,qw,qx,qy,qz,q0\n", "input/run7.csv, line 1: column 9: 'q0' occurs twice, as qw too.")]
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
        "input/run7.csv, line 2: The matrix is not a rotation: the products of its rows are wrong by up to 0.0002, 1E-06 is allowed:")]
    [InlineData(
        "time,x,y,z,r11,r12,r13,r21,r22,r23,r31,r32,r33\n1,2E6,0,0,1,0,0,0,1,0,0.5,0,1\n",
        "input/run7.csv, line 2: The matrix is not a rotation: the products of its rows are wrong by up to 0.5, 1E-06 is allowed:")]
    [InlineData("time,rx,ry,rz,q0,q1,q2,q3\n1,2,3,4,5,x,6,7\n", "input/run7.csv, line 2, column q1: 'x' is not a number")]
    [InlineData("# msis: fram=j2000\n", "input/run7.csv, line 1: 'fram' is not a key of a '# msis:' line: did you mean frame?")]
    [InlineData("# msis: frame\n", "input/run7.csv, line 1: 'frame' has no value; write frame=VALUE, without blanks.")]
    [InlineData(
        "#\n# MSIS: Frame=moon_pa\n",
        "input/run7.csv, line 2: 'frame' is 'moon_pa'; one of moon-me, moon-me-epoch, j2000 is needed.")]
    [InlineData("#msis: frame=j2000 frame=j2000\n", "input/run7.csv, line 1: 'frame' is said twice: here, and before or by --batch-")]
    [InlineData("# msis: euler=zyx\n", "input/run7.csv, line 1: 'zyx' in small letters means turns about axes at rest in some")]
    [InlineData("# msis: euler=XXY\n", "input/run7.csv, line 1: 'XXY' is not a sequence of Euler angles; three axes such as ZYX")]
    [InlineData("# msis: epoch=2460329\n", "input/run7.csv, line 1: '2460329' looks like a Julian Date")]
    [InlineData("time,x,y,z # msis: frame=j2000\n", "input/run7.csv, line 1: a '# msis:' line is a line of its own, above the names")]
    [InlineData("time,x,y,z\n# msis: frame=j2000\n", "input/run7.csv, line 2: a '# msis:' line is a line of its own, above the names")]
    [InlineData("1 2E6 0 0 0 0 0 1\n# msis: frame=j2000\n", "input/run7.csv, line 2: a '# msis:' line is a line of its own")]
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
    public void Read_IgnoredColumnsWithoutNames_IsRefused()
    {
        using StringReader reader = new("60328.5 2E6 0 0 0 0 0 1");

        Assert.StartsWith(
            "input/run7.csv, line 1: --ignore-columns has no meaning: the file names no columns.",
            Assert.Throws<BadInputException>(() => BatchFileReader.Read(
                reader, FileName, new SphereScene(), new BatchConventions { IgnoresColumns = true })).Message,
            StringComparison.Ordinal);
    }
}
