using System.Collections.Concurrent;
using Msisf.Adapters.Terrain;
using Msisf.App.Host;
using Msisf.App.Preparation;
using Msisf.App.Rendering;

namespace Msisf.App.Serving;

/// <summary>An elevation model that frames are drawn from again and again; opened at the first frame. Thread-safe.</summary>
internal sealed class ServedModel : IDisposable
{
    /// <summary>Number of errors of levels of detail for which renderers are kept; clients choose the error.</summary>
    private const int MaxLevels = 8;

    private readonly Lazy<ElevationModel> _model;
    private readonly ConcurrentDictionary<double, Lazy<NativeLevels>> _levels = new();

    /// <param name="set">The model's labels.</param>
    /// <param name="ldem">The user's <c>--ldem</c>, or null.</param>
    /// <param name="host">Output, log, clock and environment of the program.</param>
    public ServedModel(LdemSet set, string? ldem, ProgramHost host)
    {
        Name = set.ProductId;
        PixelsPerDegree = set.PixelsPerDegree;
        IsSynthetic = set.IsSynthetic;
        _model = new Lazy<ElevationModel>(() => ElevationModel.Open(ldem, set.PixelsPerDegree, isSparing: false, host));
    }

    /// <summary>Name of the model: that of its product, e.g. "LDEM_64".</summary>
    public string Name { get; }

    /// <summary>Samples a degree.</summary>
    public int PixelsPerDegree { get; }

    /// <summary>Whether this is a synthetic model.</summary>
    public bool IsSynthetic { get; }

    /// <summary>The model.</summary>
    public ElevationModel Opened => _model.Value;

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
            _ => new Lazy<NativeLevels>(() => new NativeLevels(Opened.DetailOf(errorPixels)))).Value;
    }

    /// <summary>Closes the model.</summary>
    public void Dispose()
    {
        if (_model.IsValueCreated)
        {
            _model.Value.Dispose();
        }
    }
}
