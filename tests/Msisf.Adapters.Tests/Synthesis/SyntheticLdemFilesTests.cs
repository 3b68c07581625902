using Msisf.Adapters.Synthesis;
using Msisf.Core.Errors;
using Msisf.Core.Terrain;
using Msisf.TestSupport;
using Xunit;
using static Msisf.Adapters.Tests.Synthesis.SyntheticLdemWriterTests;

namespace Msisf.Adapters.Tests.Synthesis;

/// <summary>Which files are replaced or left alone, and what stops the writer.</summary>
public sealed class SyntheticLdemFilesTests : IDisposable
{
    private readonly string _folder = Directory.CreateTempSubdirectory("msisf-synthetic-").FullName;

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Fact]
    public void Write_OverFilesThatAreNotSynthetic_LeavesThem()
    {
        string label = Path.Combine(_folder, "LDEM_4_SYNTHETIC.LBL");
        File.WriteAllText(label, "DATA_SET_ID = \"LRO-L-LOLA-4-GDR-V1.0\"\n");
        Assert.Throws<BadInputException>(() => SyntheticLdemWriter.Write(Options(4, "."), null, CancellationToken.None));
        Assert.Equal([label], Directory.GetFiles(_folder));
        Assert.StartsWith("DATA_SET_ID", File.ReadAllText(label), StringComparison.Ordinal);
    }

    [Fact]
    public void Write_ImageWithoutLabel_LeavesIt()
    {
        File.WriteAllText(Path.Combine(_folder, "LDEM_4_SYNTHETIC.IMG"), "somebody's");
        Assert.Throws<BadInputException>(() => SyntheticLdemWriter.Write(Options(4, "."), null, CancellationToken.None));
    }

    [Fact]
    public void Write_OverSyntheticProduct_ReplacesIt()
    {
        SyntheticLdemOptions options = Options(4, ".") with { Region = new MoonRegion(0, 1, 0, 1) };
        byte[] first = Image(options);
        Assert.NotEqual(first, Image(options with { Seed = 2 }));
        Assert.Equal(2, Directory.GetFiles(_folder).Length);
    }

    [Fact]
    public void Write_Cancelled_LeavesNothing()
    {
        using CancellationTokenSource source = new();
        Progress progress = new(_ => source.Cancel());
        Assert.ThrowsAny<OperationCanceledException>(() => SyntheticLdemWriter.Write(Options(8, "."), progress, source.Token));
        Assert.Empty(Directory.GetFiles(_folder));
    }

    [Fact]
    public void Write_Progress_EndsAtOne()
    {
        List<double> fractions = [];
        SyntheticLdemWriter.Write(Options(4, ".") with { Threads = 1 }, new Progress(fractions.Add), CancellationToken.None);
        Assert.Equal(1.0, fractions[^1]);
        Assert.Equal(fractions.Order(), fractions);
        Assert.InRange(fractions.Count, 10, 1000); // one for each block of some degrees
    }

    [Fact]
    public void Write_HeightsBeyond16Bits_SaysWhere()
    {
        SyntheticLdemOptions options = Options(8, ".") with { Base = FunctionGrid.OfHeights(4, (_, _) => 17_000.0) };
        BadInputException exception = Assert.Throws<BadInputException>(
            () => SyntheticLdemWriter.Write(options, null, CancellationToken.None));
        Assert.Contains("does not fit 16 bits", exception.Message, StringComparison.Ordinal);
        Assert.Empty(Directory.GetFiles(_folder));
    }

    [Fact]
    public void Write_RegionThatIsNone_IsUsageError() =>
        Assert.Throws<UsageException>(
            () => SyntheticLdemWriter.Write(Options(4, ".") with { Region = default }, null, CancellationToken.None));

    [Fact]
    public void RequireSpace_FullDisk_SaysHowMuchIsNeeded()
    {
        ExternalPartException exception = Assert.Throws<ExternalPartException>(
            () => SyntheticProductFiles.RequireSpace("output", 530_841_600, 100_000_000));
        Assert.StartsWith("output: the model needs 530.8 MB and the disk has 100.0 MB free.", exception.Message, StringComparison.Ordinal);
    }

    /// <summary>Reports at once, on the thread that works; System.Progress posts.</summary>
    private sealed class Progress(Action<double> report) : IProgress<double>
    {
        private readonly Lock _gate = new();

        public void Report(double value)
        {
            lock (_gate)
            {
                report(value);
            }
        }
    }

    private SyntheticLdemOptions Options(int pixelsPerDegree, string subfolder) =>
        new(pixelsPerDegree, Seed: 1, Path.Combine(_folder, subfolder));
}
