using Msisf.Adapters.Input;
using Msisf.Core.Errors;
using Msisf.Core.Numerics;
using Msisf.Core.Scene;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.Adapters.Tests.Input;

public class BatchFileReaderTests
{
    private const string File = "input/run7.tab";
    private const string Good = "55289 2E6 2E6 0 0 0 0 1";

    // Thesis section 6.3.2.
    private const string ThesisExample =
        """
        55289 +2.00000E+006 +2.00000E+006 +0 +0.0E+0 0 +3.82683E-001 +9.23879E-001
        5.5289E4 -2000000 2000000 0 0 +0.00000E+000 -9.23879E-001 +3.82683E-001
        55289 +2.0E6 2E6 0.00 -2.39117e-001 +9.90457E-2 +3.69643e-1 +8.92399E-001
        """;

    [Fact]
    public void Read_ThesisExample_ThreeStatesInOrder()
    {
        IReadOnlyList<SpacecraftState> states = Read(ThesisExample);

        Assert.Equal([55289.0, 55289.0, 55289.0], states.Select(state => state.Time.Mjd));
        Assert.Equal(
            [new Vector3D(2e6, 2e6, 0.0), new Vector3D(-2e6, 2e6, 0.0), new Vector3D(2e6, 2e6, 0.0)],
            states.Select(state => state.PositionBodyFixed));

        // 1: the printed quaternions have 6 digits and are normalised.
        Assert.Equal(-0.923879, states[1].MoonFromCamera.Z, 1e-6);
        Assert.Equal(0.382683, states[1].MoonFromCamera.W, 1e-6);
        Assert.Equal(-0.239117, states[2].MoonFromCamera.X, 1e-6);
    }

    [Theory]
    [InlineData(Good)]
    [InlineData(Good + "\n")]
    [InlineData(Good + "\r\n")]
    [InlineData("\uFEFF" + Good + "\n")]
    [InlineData("\t55289\t2E6  2E6\t \t0 0 0 0 1   \n")]
    [InlineData("# a comment, h\u00F6he\r\n\r\n   \r\n" + Good + " # trailing\r\n#end")]
    [InlineData("#\n" + Good + "#1 2 3")]
    public void Read_AnyLayout_OneState(string text) =>
        Assert.Equal(Moments.StateOf([55289.0, 2e6, 2e6, 0.0, 0.0, 0.0, 0.0, 1.0]), Assert.Single(Read(text)));

    [Theory]
    [InlineData("")]
    [InlineData("\uFEFF")]
    [InlineData("\r\n\n# nothing yet")]
    public void Read_NoState_Empty(string text) => Assert.Empty(Read(text));

    [Theory]
    [InlineData("\n# x\n" + Good + "\n55289 2E6 2E6 0 abc 0 0 1", "input/run7.tab, line 4, column 17: 'abc' is not a number; ")]
    [InlineData("\uFEFFMJD rx ry rz", "input/run7.tab, line 1, column 1: 'MJD' is not a number; ")]
    [InlineData("55289 2E6\r\n", "input/run7.tab, line 1: 2 numbers, 8 expected (MJD rx ry rz qx qy qz q0). Complete or remove the line.")]
    [InlineData(
        "55289 2E6 2E6 0 0 0 1", "input/run7.tab, line 1: 7 numbers, 8 expected (MJD rx ry rz qx qy qz q0). Complete or remove the line.")]
    [InlineData(Good + " 5", "input/run7.tab, line 1: 9 numbers, 8 expected (MJD rx ry rz qx qy qz q0). Shorten or remove the line.")]
    [InlineData(Good + " x", "input/run7.tab, line 1, column 25: 'x' is not a number")]
    [InlineData("55289 2E6 NaN 0 0 0 0 1", "input/run7.tab, line 1, column 11: 'NaN' is not finite")]
    [InlineData("55289 2E6 1e999 0 0 0 0 1", "input/run7.tab, line 1, column 11: '1e999' is too large")]
    [InlineData("55289,2E6,2E6,0,0,0,0,1", "input/run7.tab, line 1, column 1: '55289,2E6,2E6,0,0,0,0,1' has a comma")]
    [InlineData(Good + "\n55289 2E6 2E6 0 0 0 0 0.9", "input/run7.tab, line 2: The quaternion {0,0,0,0.9} has length 0.9")]
    [InlineData("5528900 2E6 2E6 0 0 0 0 1", "input/run7.tab, line 1, column 1: The MJD 5528900 is not a date")]
    [InlineData(Good + "\n\uFFFDPNG\r\n\u001A\n", "input/run7.tab, line 2, column 1: '\uFFFDPNG' is not UTF-8 text")]
    [InlineData("5528\0", "input/run7.tab, line 1, column 5: control character U+0000; this is not a text file.")]
    public void Read_BadLine_NamesFileLineAndColumn(string text, string message) =>
        Assert.StartsWith(message, Assert.Throws<BadInputException>(() => Read(text)).Message, StringComparison.Ordinal);

    [Fact]
    public void Read_EnormousLine_RefusedWithoutEchoOrMemory()
    {
        using EndlessReader endless = new();
        BadInputException failure = Assert.Throws<BadInputException>(() => BatchFileReader.Read(endless, File, new SphereScene()));
        Assert.Equal("input/run7.tab, line 1: longer than 65536 characters; this is not a file of numbers in lines.", failure.Message);
    }

    [Fact]
    public void Read_LineThatEndsPastTheBuffer_IsWhole()
    {
        // The long comment makes the second state cross the end of the first 65,537 characters.
        string text = "#" + new string('x', 65_500) + "\n" + Good + "\n" + Good + "\n" + Good;
        Assert.Equal(3, Read(text).Count);
        Assert.Single(Read(Good + " #" + new string('x', 65_536 - Good.Length - 2)));
    }

    [Fact]
    public void Read_ReaderGivesOneCharacterAtATime_IsTheSame()
    {
        using TricklingReader trickling = new(ThesisExample);
        Assert.Equal(Read(ThesisExample), BatchFileReader.Read(trickling, File, new SphereScene()));
    }

    [Fact]
    public void Read_FileSystemFails_NamesTheFile()
    {
        using FailingReader failing = new();
        ExternalPartException failure = Assert.Throws<ExternalPartException>(() => BatchFileReader.Read(failing, File, new SphereScene()));
        Assert.Equal("input/run7.tab: can't be read after line 0: disk gone", failure.Message);
    }

    private static IReadOnlyList<SpacecraftState> Read(string text)
    {
        using StringReader reader = new(text);
        return BatchFileReader.Read(reader, File, new SphereScene());
    }

    private sealed class EndlessReader : TextReader
    {
        public override int Read(char[] buffer, int index, int count)
        {
            Array.Fill(buffer, '7', index, count);
            return count;
        }
    }

    private sealed class TricklingReader(string text) : TextReader
    {
        private int _next;

        public override int Read(char[] buffer, int index, int count)
        {
            if (_next == text.Length)
            {
                return 0;
            }

            buffer[index] = text[_next++];
            return 1;
        }
    }

    private sealed class FailingReader : TextReader
    {
        public override int Read(char[] buffer, int index, int count) => throw new IOException("disk gone");
    }
}
