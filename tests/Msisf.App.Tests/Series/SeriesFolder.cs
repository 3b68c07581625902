using System.Text;
using Msisf.Adapters.IO;
using Msisf.Adapters.Manifest;
using Msisf.Adapters.Raster.Heights;
using Msisf.App.Preparation;
using Msisf.App.Series;
using Msisf.App.Tests.Host;
using Msisf.Core.Scene;
using Msisf.TestSupport;

namespace Msisf.App.Tests.Series;

/// <summary>A folder of outputs whose frames are some bytes.</summary>
internal sealed class SeriesFolder : IDisposable
{
    private readonly TemporaryFolder _folder = new();

    public string Path => _folder.Path;

    public string this[string name] => _folder[name];

    /// <summary>What was said.</summary>
    public ListLog Log { get; } = new();

    /// <summary>The manifest as it is now.</summary>
    public ManifestContent Manifest => SeriesManifest.Read(Path, Log);

    public void Dispose() => _folder.Dispose();

    public void Write(string name, string text) => _folder.Write(name, text);

    /// <summary>A run whose frames have these names, and times that differ.</summary>
    public static RunPlan Plan(string arguments, params string[] names) => new([new PlannedCamera(
        [.. names.Select((_, index) => Moments.StateOf([55289.0 + index, 2e6, 0, 0, 0, 0, 0, 1]))],
        names,
        RunIdentity.Of("2.0", arguments, new LdemFingerprint("LDEM_4", 1, "aa"), null, [], null, []))]);

    public FrameLedger Open(RunPlan plan, bool overwrite = false) => new(Path, plan, overwrite, Log);

    public static Frame Frame(RunPlan plan, int step) => new(step, plan.Expected(step).Name, default, null!, default);

    /// <summary>Makes a frame of files with these endings; each holds its own name.</summary>
    public void Make(FrameLedger ledger, int step, params string[] endings)
    {
        Frame frame = Frame(ledger.Plan, step);
        string[] paths = [.. endings.Select(ending => this[frame.Name + ending])];
        using AtomicFileSet files = new(ledger.Staging);
        foreach (string path in paths)
        {
            files.Write(path, stream => stream.Write(Encoding.UTF8.GetBytes(System.IO.Path.GetFileName(path))));
        }

        ledger.Made(frame, files, paths);
        files.Commit();
    }

    /// <summary>Makes frames of a run.</summary>
    public void Make(RunPlan plan, params int[] steps)
    {
        using FrameLedger ledger = Open(plan);
        foreach (int step in steps)
        {
            Make(ledger, step, ".png");
        }
    }
}
