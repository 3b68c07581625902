using System.Collections.Concurrent;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Rendering;
using Msisf.App.Settings;
using Msisf.Core.Render;
using Msisf.Core.Terrain;

namespace Msisf.App.Serving;

/// <summary>
/// An elevation model, or several as one surface, that frames are drawn from again and again; opened at the first frame. Thread-safe.
/// </summary>
internal sealed class ServedModel : IDisposable
{
    /// <summary>Number of errors of levels of detail for which renderers are kept; clients choose the error.</summary>
    private const int MaxLevels = 8;

    /// <summary>px: a server draws frames of all sizes; the memory of larger ones, some GB, it returns when they are drawn.</summary>
    private const long LargestFrameKept = 2048 * 2048;

    private readonly Lazy<ElevationModel> _model;
    private readonly ConcurrentDictionary<double, Lazy<NativeLevels>> _levels = new();

    /// <param name="name">Name of its product.</param>
    /// <param name="path">Its label, or the file itself.</param>
    /// <param name="ldem">The <c>--ldem</c> that means it; null if a run finds it without.</param>
    public ServedModel(
        string name, GridResolution resolution, bool isSynthetic, bool isWholeMoon, string path, string? ldem, ProgramHost host)
        : this(
            name, resolution, isSynthetic, ldem is null ? [] : [ldem],
            () => ModelOpening.Open(ldem, resolution, isSparing: false, host)) =>
        (IsWholeMoon, Path) = (isWholeMoon, path);

    private ServedModel(
        string name, GridResolution resolution, bool isSynthetic, IReadOnlyList<string> ldem, Func<ElevationModel> open)
    {
        (Name, Resolution, IsSynthetic, Ldem) = (name, resolution, isSynthetic, ldem);
        _model = new Lazy<ElevationModel>(open);
    }

    /// <summary>Name of the model: that of its product, e.g. "LDEM_64"; of several their names with "+" between them.</summary>
    public string Name { get; }

    /// <summary>Its resolution; of several that of the finest.</summary>
    public GridResolution Resolution { get; }

    /// <summary>Whether this is a synthetic model, or one of several is.</summary>
    public bool IsSynthetic { get; }

    public bool IsWholeMoon { get; private init; } = true;

    /// <summary>Its label, or the file itself; empty for several.</summary>
    public string Path { get; private init; } = string.Empty;

    /// <summary>The <c>--ldem</c> of a run that draws it; empty if the run finds it without.</summary>
    public IReadOnlyList<string> Ldem { get; }

    public bool IsSeveral => Ldem.Count > 1;

    public ElevationModel Opened => _model.Value;

    /// <summary>Several models as one surface.</summary>
    /// <param name="models">Two or more.</param>
    public static ServedModel Of(IReadOnlyList<ServedModel> models, string name, ProgramHost host)
    {
        string[] paths = [.. models.Select(model => model.Path)];
        return new ServedModel(
            name,
            models.MinBy(model => model.Resolution.MetresPerPixel)!.Resolution,
            models.Any(model => model.IsSynthetic),
            paths,
            () => ModelOpening.OpenSeveral(paths, hasLevels: true, host));
    }

    /// <summary>The same model with invented detail. Its files stay those of this model, which closes them.</summary>
    /// <param name="detail">What is invented.</param>
    public ServedModel With(RefineSettings detail, ProgramHost host) =>
        new(Name, Resolution, IsSynthetic, Ldem, () => Opened.Refined(detail, host, isClosedWithIt: false))
        {
            IsWholeMoon = IsWholeMoon,
            Path = Path,
        };

    /// <summary>The renderers of the model; they keep what they have read.</summary>
    /// <param name="errorPixels">px: how far coarser levels may shift a point in the image; null to draw from the full model.</param>
    public NativeLevels LevelsFor(double? errorPixels)
    {
        if (_levels.Count > MaxLevels)
        {
            _levels.Clear(); // sessions in use keep theirs
        }

        return _levels.GetOrAdd(
            errorPixels ?? -1.0,
            _ => new Lazy<NativeLevels>(() => new NativeLevels(
                Opened.DetailOf(errorPixels), new RendererMemory { LargestKept = LargestFrameKept }))).Value;
    }

    public void Dispose()
    {
        if (_model.IsValueCreated)
        {
            _model.Value.Dispose();
        }
    }
}
