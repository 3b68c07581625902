using Msisf.Core.Errors;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.MySql.Tests;

public class ImportedModelTests
{
    private static readonly FunctionGrid Grid = FunctionGrid.Rough(2);

    public static TheoryData<string, object[][]> Refused => new()
    {
        { "no elevation model", [] },
        { "not complete (350 of 360 lines, state importing)", [FakeMoon.Record("LDEM_2", "importing", done: 350)] },
        { "state removing", [FakeMoon.Record("LDEM_2", "removing")] },
        { "imported in format 2", [FakeMoon.Record("LDEM_2", format: 2)] },
        { "several models (LDEM_2, OTHER)", [FakeMoon.Record("LDEM_2"), FakeMoon.Record("OTHER")] },
        { "without a proper name", [FakeMoon.Record("*/ #include \"x\"")] },
    };

    [Theory]
    [MemberData(nameof(Refused))]
    public void Open_RecordsThatAreNoWholeModel_AreRefused(string message, object[][] records)
    {
        BadInputException exception = Assert.Throws<BadInputException>(() => LdemTableGrid.Open(new FakeMoon(Grid, records).Database, 2));
        Assert.Contains(message, exception.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Open_PartsOfOneModel_HaveTheModelsName()
    {
        FakeMoon moon = new(Grid, FakeMoon.Record("LDEM_512_00N_45N_000_090"), FakeMoon.Record("LDEM_512_45S_00S_090_180"));
        Assert.Equal("LDEM_512", LdemTableGrid.Open(moon.Database, 2).ProductId);
    }
}
