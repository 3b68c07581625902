using Msisf.App.Rendering;
using Xunit;

namespace Msisf.App.Tests.Rendering;

public sealed class OrderedPrinterTests
{
    [Fact]
    public void Done_StepsThatEndInAnyOrder_ArePrintedInTheOrderOfTheSteps()
    {
        using StringWriter results = new() { NewLine = "\n" };
        OrderedPrinter printer = new(results, 4);

        printer.Done(2, ["c1", "c2"]);
        Assert.Equal(string.Empty, results.ToString());

        printer.Done(0, ["a"]);
        Assert.Equal("a\n", results.ToString());

        printer.Done(1, []);
        Assert.Equal("a\nc1\nc2\n", results.ToString());

        printer.Done(3, ["d"]);
        Assert.Equal("a\nc1\nc2\nd\n", results.ToString());
    }
}
