using Msisf.Adapters.Input;
using Msisf.Core.Camera;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Xunit;

namespace Msisf.Adapters.Tests.Input;

public sealed class JitterFileReaderTests
{
    [Fact]
    public void Read_Samples_AreMicroradians()
    {
        Jitter jitter = Read("seconds,roll,pitch,yaw\n# a log\n-1 10 20 30\n\n0.5,1,-2,3 # later\n");

        Assert.Equal((-1.0, 0.5), jitter.Cover);
        AssertClose(new Vector3D(10e-6, 20e-6, 30e-6), jitter.AnglesAt(-1.0));
        AssertClose(new Vector3D(1e-6, -2e-6, 3e-6), jitter.AnglesAt(0.5));
    }

    [Fact]
    public void Read_Sines_AreSummed()
    {
        Jitter jitter = Read("pitch 5 20 0\r\nyaw 0 7 1.5707963267948966\nroll 2.5 4 0.1\n");

        AssertClose(new Vector3D(4e-6 * Math.Sin(0.1 + (0.25 * Math.PI)), 20e-6, 7e-6), jitter.AnglesAt(0.05));
    }

    [Theory]
    [InlineData("", "j.txt: no line of jitter is in it. Add one.")]
    [InlineData("# nothing\n", "j.txt: no line of jitter is in it. Add one.")]
    [InlineData(
        "0 1 2\n",
        "j.txt, line 1: 3 values, 4 are needed: seconds, roll, pitch and yaw, or an axis, frequency, amplitude and phase.")]
    [InlineData("0 1 2 3\n0 1 2 3\n", "j.txt, line 2: 0 s is not later than the line before. Put the lines in the order of their times.")]
    [InlineData(
        "0 1 2 3\nroll 1 2 3\n",
        "j.txt, line 2: a line of an axis with its sine and one of seconds can't be in one file. Choose one kind.")]
    [InlineData("rol 1 2 3\n", "j.txt, line 1: 'rol' is not a number; write")]
    [InlineData("0 1 nan 3\n", "j.txt, line 1: 'nan' is not finite")]
    public void Read_Wrong_SaysWhere(string text, string message) =>
        Assert.StartsWith(message, Assert.Throws<BadInputException>(() => Read(text)).Message, StringComparison.Ordinal);

    private static Jitter Read(string text) => JitterFileReader.Read(new StringReader(text), "j.txt");

    // rad: hundreds of ulps of some microradians
    private static void AssertClose(Vector3D expected, Vector3D actual) => Assert.InRange((expected - actual).Length, 0.0, 1e-18);
}
