using Msisf.Adapters.IO;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Products;
using Msisf.App.Series;
using Msisf.App.Settings;
using Msisf.Core.Metadata;

namespace Msisf.App.Rendering;

/// <summary>
/// Writes the products of a frame for all renderers. The files appear when all are complete and recorded in the manifest, the image last.
/// Thread-safe.
/// </summary>
internal sealed class FrameFiles(
    RenderSettings settings, FrameDescription description, InputComparison comparison, FrameLedger ledger, RunTimes times,
    ProductTools tools, NavigationInputs? navigation = null, CraterNote? craters = null)
{
    private readonly FrameNavigation? _navigation = navigation is null ? null : new FrameNavigation(navigation);
    private readonly Product[] _products = [.. ProductTable.Of(settings)];

    /// <summary>A file for an image that is written as it is drawn; it goes when it is closed.</summary>
    public FileStream OpenTemporary() => new(
        Path.Combine(ledger.Staging, Path.GetRandomFileName()), FileMode.CreateNew, FileAccess.ReadWrite, FileShare.None, 1 << 16,
        FileOptions.DeleteOnClose);

    /// <param name="cancellation">Cancels the work; no file is left.</param>
    /// <returns>The paths of the files, in the order in which they are shown to the user.</returns>
    public IReadOnlyList<string> Write(Frame frame, RenderedFrame rendered, CancellationToken cancellation)
    {
        string stem = Path.Combine(settings.OutputFolder, frame.Name);
        FrameMetadata metadata = description.Describe(frame, rendered, ledger.Plan.ArgumentsOf(frame.Step, frame.CameraIndex)) with
        {
            Navigation = times.Measure(Phase.Navigation, () => _navigation?.Of(rendered)),
        };
        if (metadata.Navigation?.Craters is { } listed)
        {
            craters?.Add(listed);
        }

        comparison.Compare($"{stem}.xml", metadata.Inputs);
        ProductFrame written = description.ToProducts(frame, rendered, metadata, tools, cancellation);
        List<string> paths = [];
        using AtomicFileSet files = new(ledger.Staging);
        foreach (Product product in _products)
        {
            times.Measure(product.Phase, () => product.Write(written, files.Under(stem, paths)));
        }

        cancellation.ThrowIfCancellationRequested();
        times.Measure(Phase.Output, () =>
        {
            ledger.Made(frame, files, paths);
            files.Commit(lastFirst: true);
        });
        return paths;
    }
}
