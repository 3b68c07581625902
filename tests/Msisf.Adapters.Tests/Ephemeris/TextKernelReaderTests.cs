using Msisf.Adapters.Ephemeris;
using Msisf.Core.Errors;
using Xunit;

namespace Msisf.Adapters.Tests.Ephemeris;

public class TextKernelReaderTests
{
    [Fact]
    public void Read_NumbersTextsAndLists_AreTaken()
    {
        KernelPool pool = Read(
            "KPL/FK\nA = 'ignored'\n\\begindata\nA=1.657D-3\nB = ( 1,2\n 3 , "
                + "-4.5d+1)\nC = 'it''s'\n\n\\begintext\nD = 5\n\\begindata\nE = +7\n");

        Assert.Equal([1.657e-3], pool.Existing("A").Numbers);
        Assert.Equal([1.0, 2.0, 3.0, -45.0], pool.Existing("B").Numbers);
        Assert.Equal(["it's"], pool.Existing("C").Texts);
        Assert.Null(pool.Find("D"));
        Assert.Equal(7, pool.WholeNumber("E"));
    }

    [Fact]
    public void Read_WindowsLineEndsAndTabs_AreBlanks() =>
        Assert.Equal([1.0, 2.0], Read("\\begindata\r\nA\t=\t(1\r\n\t2)\r\n\\begintext\r\n").Existing("A").Numbers);

    [Fact]
    public void Read_AssignedTwice_TheLaterWins() =>
        Assert.Equal([2.0], Read("\\begindata\nA = 1\nA = 2\n").Existing("A").Numbers);

    [Fact]
    public void Read_Appended_GoesOn() =>
        Assert.Equal([1.0, 2.0, 3.0], Read("\\begindata\nA = 1\nA += ( 2 )\nA+=3\n").Existing("A").Numbers);

    [Fact]
    public void Read_AppendedToNothing_IsAssigned() =>
        Assert.Equal(["x"], Read("\\begindata\nA += 'x'\n").Existing("A").Texts);

    [Theory]
    [InlineData("@1972-JAN-1", -883656000.0)]
    [InlineData("@1972-January-01", -883656000.0)]
    [InlineData("@1972-1-1", -883656000.0)]
    [InlineData("@2000-JAN-01-12:00:00", 0.0)]
    [InlineData("@2000/jan/2-00:30:01.5", 45001.5)]
    [InlineData("@2009-06-10T12:57:27.4670", 297910647.467)] // this and the next ones: CSPICE N0067, tparse_c
    [InlineData("@1994-301//12:00", -163382400.0)]
    [InlineData("@10/28/1994", -163425600.0)]
    [InlineData("@2449653.5JD", -163425600.0)]
    [InlineData("@28-OCT-94", 915278400.0)] // of two digits at either end, the first are the year
    [InlineData("@1972-FEB-30", -878472000.0)]
    public void Read_Dates_AreSecondsPast2000(string date, double expected) =>
        Assert.Equal([expected], Read($"\\begindata\nA = {date}\n").Existing("A").Numbers);

    [Theory]
    [InlineData("A = 1\n", "no line \\begindata")]
    [InlineData("", "no line \\begindata")]
    [InlineData("\\begindata\nA = (1\n2\n", "line 2: the list of A is not closed")]
    [InlineData("\\begindata\nA = (1 'x')\n", "line 2: the list of A mixes numbers and texts")]
    [InlineData("\\begindata\nA = 'x\n", "line 2: the quote that opens at column 5")]
    [InlineData("\\begindata\n\nA = \n", "line 3: A has no value")]
    [InlineData("\\begindata\nA = ()\n", "line 2: A has no value")]
    [InlineData("\\begindata\nA 1\n", "line 2: = or += is expected after A")]
    [InlineData("\\begindata\nA = 1 2\n", "line 2: = or += is expected after 2")]
    [InlineData("\\begindata\n= 1\n", "line 2: = where the name")]
    [InlineData("\\begindata\nA = ( 1 = 2 )\n", "line 2: the list of A is not closed")]
    [InlineData("\\begindata\nA = 1,5x\n", "= or += is expected after 5x")]
    [InlineData("\\begindata\nA = five\n", "line 2: A has the value five")]
    [InlineData("\\begindata\nA = NaN\n", "A has the value NaN")]
    [InlineData("\\begindata\nA = 1D999\n", "A has the value 1D999")]
    [InlineData("\\begindata\nA = @1972-FOO-1\n", "@1972-FOO-1")]
    [InlineData("\\begindata\nA = @1972-32\n", "@1972-32")]
    [InlineData("\\begindata\nA = @1972-ANJ-3\n", "@1972-ANJ-3")]
    [InlineData("\\begindata\nA = @1972-JAN-1-12:00UTC\n", "@1972-JAN-1-12:00UTC")]
    [InlineData("\\begindata\nA = @\n", "A has the value @; ")]
    [InlineData("\\begindata\nA = 1\nA += 'x'\n", "A += mixes numbers and texts")]
    public void Read_Wrong_SaysWhereAndWhat(string text, string expected)
    {
        BadInputException failure = Assert.Throws<BadInputException>(() => Read(text));

        Assert.StartsWith("sample.tf", failure.Message, StringComparison.Ordinal);
        Assert.Contains(expected, failure.Message, StringComparison.Ordinal);
    }

    private static KernelPool Read(string text)
    {
        KernelPool pool = new();
        TextKernelReader.Read(new StringReader(text), "sample.tf", pool);
        return pool;
    }
}
