using System.Globalization;
using Msisf.Core.Errors;
using Msisf.Core.Terrain;

namespace Msisf.Core.Mesh.Nesting;

/// <summary>
/// Several elevation models as one closed surface: everywhere the finest model that has data, joined without a crack and without a step
/// (docs/elevation-models.md). The seams are made when the surface is first needed. Safe for several threads.
/// </summary>
public sealed class NestedTerrain : ITerrain
{
    /// <summary>Maximum number of models.</summary>
    public const int MaxModels = 100;

    private readonly Lazy<SurfaceModel> _surface;
    private readonly Lazy<IReadOnlyList<GridSurface>> _whole;

    /// <summary>Takes the models; nothing is read yet.</summary>
    /// <param name="models">Two or more, in any order; the coarsest is one of the whole Moon.</param>
    /// <exception cref="BadInputException">They are no such models.</exception>
    public NestedTerrain(IEnumerable<ITerrainGrid> models)
    {
        Models = [.. models.OrderByDescending(model => model.Projection.Resolution.MetresPerPixel)
            .ThenByDescending(model => model.ProductId, StringComparer.Ordinal)];
        if (Models.Count is < 2 or > MaxModels)
        {
            throw new BadInputException($"{Models.Count} elevation models: 2 to {MaxModels} make a scene of several.");
        }

        if (Models[0] is not IElevationGrid)
        {
            throw new BadInputException(
                $"{Models[0].ProductId}, the coarsest of several elevation models, is not of the whole Moon. Give one that is as well, for "
                    + "instance LDEM_4: around the others there would be nothing, and no horizon would throw shadows.");
        }

        if (Models.Skip(1).FirstOrDefault(model => model is IElevationGrid) is { } whole)
        {
            throw new BadInputException(
                $"{whole.ProductId} is of the whole Moon and finer than {Models[0].ProductId}, of which nothing would be seen. "
                    + "Leave that one out.");
        }

        if (Models.FirstOrDefault(model => model.ReferenceRadius != Models[0].ReferenceRadius) is { } other)
        {
            throw new BadInputException(string.Create(
                CultureInfo.InvariantCulture,
                $"{other.ProductId} has heights over a sphere of {other.ReferenceRadius:R} m, {Models[0].ProductId} over one of "
                    + $"{Models[0].ReferenceRadius:R} m: they are of different bodies. Leave one of them out."));
        }

        _whole = new Lazy<IReadOnlyList<GridSurface>>(Blend);
        _surface = new Lazy<SurfaceModel>(Join);
    }

    /// <summary>The models, the coarsest first; a facet's part is an index here.</summary>
    public IReadOnlyList<ITerrainGrid> Models { get; }

    /// <inheritdoc/>
    public double ReferenceRadius => Models[0].ReferenceRadius;

    /// <inheritdoc/>
    public int PartCount => Models.Count;

    /// <inheritdoc/>
    public string ProductId => string.Join('+', Models.Select(model => model.ProductId));

    /// <inheritdoc/>
    public GridResolution Resolution => Models[^1].Projection.Resolution;

    /// <inheritdoc/>
    public (double Min, double Max) RadiusLimits =>
        (Models.Min(model => model.RadiusLimits.Min), Models.Max(model => model.RadiusLimits.Max));

    /// <summary>The surface; made at the first request.</summary>
    /// <exception cref="BadInputException">The models can't be joined.</exception>
    internal SurfaceModel Surface => _surface.Value;

    /// <summary>The models with all their cells, each blended into the coarser ones along its border.</summary>
    internal IReadOnlyList<GridSurface> Whole => _whole.Value;

    /// <summary>Makes the surface now, so that an error is told before any work.</summary>
    /// <exception cref="BadInputException">The models can't be joined.</exception>
    public void Prepare() => _ = Surface;

    /// <inheritdoc/>
    public void ReleasePages()
    {
        foreach (ITerrainGrid model in Models)
        {
            model.ReleasePages();
        }
    }

    private List<GridSurface> Blend()
    {
        List<GridSurface> blended = [new GridSurface(Models[0])];
        foreach (ITerrainGrid model in Models.Skip(1))
        {
            blended.Add(new GridSurface(new BorderBlend(model, new CoarserGround(blended))));
        }

        return blended;
    }

    private SurfaceModel Join()
    {
        GridSurface[] parts = new GridSurface[Whole.Count];
        for (int part = parts.Length - 1; part >= 0; part--)
        {
            parts[part] = Whole[part].WithCells(KeptCells.Of(Whole[part], parts[(part + 1)..]));
            if (!parts[part].Kept!.IsAny)
            {
                throw new BadInputException(
                    $"Of {Models[part].ProductId} nothing would be seen: finer models cover all of it. Leave it out.");
            }
        }

        return new SurfaceModel(parts, SeamBuilder.Join(parts, more: []));
    }
}
