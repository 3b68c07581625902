using Msisf.Core.Errors;
using Msisf.TestSupport;
using Xunit;

namespace Msisf.MySql.Tests;

[Collection(PrivateServer.Collection)]
public class ImportedModelTests(PrivateServer server)
{
    private static readonly FunctionGrid Grid = FunctionGrid.Rough(2);

    public static TheoryData<string, object[][]> Refused => new()
    {
        { "no elevation model", [] },
        { "not complete (350 of 360 lines, state importing)", [MoonTable.Record("LDEM_2", "importing", done: 350)] },
        { "state removing", [MoonTable.Record("LDEM_2", "removing")] },
        { "imported in format 2", [MoonTable.Record("LDEM_2", format: 2)] },
        { "several models (LDEM_2, OTHER)", [MoonTable.Record("LDEM_2"), MoonTable.Record("OTHER")] },
        { "without a proper name", [MoonTable.Record("*/ #include \"x\"")] },
    };

    [RequiresTheory(Part.MariaDb)]
    [MemberData(nameof(Refused))]
    public void Open_RecordsThatAreNoWholeModel_AreRefused(string message, object[][] records)
    {
        using MoonTable moon = new(server, Grid, lines: [], records);
        BadInputException exception = Assert.Throws<BadInputException>(() => LdemTableGrid.Open(moon.Database, 2));
        Assert.Contains(message, exception.Message, StringComparison.Ordinal);
    }

    [RequiresFact(Part.MariaDb)]
    public void Open_PartsOfOneModel_HaveTheModelsName()
    {
        using MoonTable moon = new(
            server, Grid, lines: [], MoonTable.Record("LDEM_512_00N_45N_000_090"), MoonTable.Record("LDEM_512_45S_00S_090_180"));
        Assert.Equal("LDEM_512", LdemTableGrid.Open(moon.Database, 2).ProductId);
    }
}
