using System.Collections.Concurrent;
using Msisf.Core.Render;
using Msisf.Core.Render.Photometry;
using Msisf.Core.Render.Visibility;
using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;

namespace Msisf.Core.Layers;

/// <summary>Computes the layers of a frame, row by row; no row is kept. Safe for several threads.</summary>
/// <param name="provenance">Resolution of the cells, and the band of the radiance.</param>
public sealed class LayerSampler(IGroundTruth truth, LayerProvenance provenance)
{
    private readonly int? _meshPixelsPerDegree = provenance.Parts > 1 ? null : provenance.MeshResolution.PixelsPerDegree;
    private readonly double _referenceRadius = provenance.ReferenceRadius;
    private readonly SpectralBand _band = provenance.Band;
    private readonly FacetSources? _sources = provenance.Sources;
    private readonly ConcurrentBag<Scratch> _idle = [];

    /// <summary>px.</summary>
    public int Width => truth.Camera.Width;

    /// <summary>px.</summary>
    public int Height => truth.Camera.Height;

    /// <summary>Rows of the parts in which a frame that is drawn row by row is best read, from the top.</summary>
    public int RowsAtOnce => truth.RowsAtOnce;

    /// <summary>Computes one row of some layers; what several of them need is computed once.</summary>
    /// <param name="row">0 (top) to <see cref="Height"/> - 1.</param>
    /// <param name="planes">
    /// Filled: the planes of the first layer, then those of the second, ...; values from left to right, in the layer's unit; NaN
    /// marks the undefined ones. Whole numbers are exact.
    /// </param>
    /// <param name="start">Where the row begins in each plane.</param>
    public void SampleRow(int row, IReadOnlyList<Layer> layers, IReadOnlyList<double[]> planes, int start)
    {
        Scratch scratch = _idle.TryTake(out Scratch? idle) ? idle : new Scratch(NewRow(), new double[Width + SurfaceRow.Padding]);
        scratch.Row.MoveTo(row);
        int next = 0;
        foreach (Layer layer in layers)
        {
            for (int plane = 0; plane < layer.Planes; plane++)
            {
                layer.Values(scratch.Row, plane, scratch.Values);
                Spread(scratch, layer, planes[next++].AsSpan(start, Width));
            }
        }

        _idle.Add(scratch);
    }

    /// <summary>Puts the values of the pixels that show the surface into their columns.</summary>
    private static void Spread(Scratch scratch, Layer layer, Span<double> plane)
    {
        LayerRow row = scratch.Row;
        if (layer.CoversImage || row.Count == plane.Length)
        {
            scratch.Values.AsSpan(0, plane.Length).CopyTo(plane);
            return;
        }

        plane.Fill(layer.Type == LayerType.Unsigned8 ? (double)IlluminationState.NoSurface : double.NaN);
        ReadOnlySpan<int> columns = row.Columns;
        for (int i = 0; i < columns.Length; i++)
        {
            plane[columns[i]] = scratch.Values[i];
        }
    }

    private LayerRow NewRow() => new(truth, _meshPixelsPerDegree, _referenceRadius, _band) { Sources = _sources };

    /// <summary>What one thread computes in.</summary>
    private sealed record Scratch(LayerRow Row, double[] Values);
}

/// <summary>Facts about a frame that the layers' files hold beyond its metadata.</summary>
/// <param name="ElevationProduct">Name of the elevation model, e.g. "LDEM_64".</param>
/// <param name="MeshResolution">
/// Resolution of the grid whose cells are counted: the model's own, or that of its level of detail.
/// </param>
/// <param name="LevelOfDetail">Level of detail; 0 is the model itself.</param>
/// <param name="Renderer">Name of the renderer, e.g. "native".</param>
public sealed record LayerProvenance(
    string ElevationProduct, GridResolution MeshResolution, int LevelOfDetail, string Renderer, SpectralBand Band)
{
    /// <summary>Number of elevation models; with several the mesh's resolution is that of the finest, and there are no tiles.</summary>
    public int Parts { get; init; } = 1;

    /// <summary>Tells where the heights of facets come from; null if all are those of one model.</summary>
    public FacetSources? Sources { get; init; }

    /// <summary>Name of the detail that was invented below the models' resolution, e.g. "REFINE_7"; null without.</summary>
    public string? InventedDetail { get; init; }

    /// <summary>m: radius of the sphere over which heights are counted.</summary>
    public double ReferenceRadius { get; init; } = MoonConstants.ReferenceRadius;
}
