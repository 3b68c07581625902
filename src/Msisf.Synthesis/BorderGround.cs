using Msisf.Core.Surface.Sources;
using Msisf.Core.Terrain;

namespace Msisf.Synthesis;

/// <summary>
/// The ground around a map of a part of the Moon: that of the coarser models with their detail, and the difference at the map's border,
/// which dies away outwards (<see cref="OutlineField"/>). Safe for several threads.
/// </summary>
internal sealed class BorderGround
{
    /// <summary>Samples of the map in a cell of the field: differences over fewer are the map's own roughness.</summary>
    private const double SamplesOfCell = 8.0;

    /// <summary>Places of the border at which the difference is found, at most; those of a large map are farther apart.</summary>
    private const int MostPlaces = 4096;

    private readonly ITerrainGrid _model;
    private readonly Func<Vector3D, double, double> _coarser;
    private readonly Lazy<OutlineField> _field;

    /// <summary>Takes a map; nothing is read yet.</summary>
    /// <param name="model">The map.</param>
    /// <param name="coarser">
    /// Height over the reference radius, m, of the ground of the coarser models in a direction (unit vector, body-fixed), for cells of a
    /// width, m.
    /// </param>
    public BorderGround(ITerrainGrid model, Func<Vector3D, double, double> coarser)
    {
        (_model, _coarser) = (model, coarser);
        Border = new ModelBorder(model);
        _field = new Lazy<OutlineField>(NewField);
    }

    /// <summary>Where the map counts.</summary>
    public ModelBorder Border { get; }

    /// <summary>m: what the ground of the coarser models gets at a place.</summary>
    /// <param name="direction">Unit vector, body-fixed.</param>
    public double ChangeAt(Vector3D direction) => _field.Value.At(direction);

    /// <summary>Whether any place near one gets something.</summary>
    /// <param name="direction">Unit vector, body-fixed.</param>
    /// <param name="around">m: how near.</param>
    public bool IsNear(Vector3D direction, double around) => _field.Value.DistanceOf(direction, around) is not null;

    /// <summary>m over the reference radius: the ground beyond the map.</summary>
    /// <param name="direction">Unit vector, body-fixed.</param>
    /// <param name="cell">m: width of the cells.</param>
    public double HeightAt(Vector3D direction, double cell) => _coarser(direction, cell) + ChangeAt(direction);

    private OutlineField NewField()
    {
        double spacing = _model.Projection.Resolution.MetresPerPixel;

        // One difference for all widths of cells: finer cells add detail, and change nothing else.
        double cell = Math.ScaleB(1.0, (int)Math.Floor(Math.Log2(spacing)));
        IReadOnlyList<OutlineSample> samples = new Outline(_model, OutlineField.PieceOf(SamplesOfCell * spacing)).Samples;
        int step = ((samples.Count - 1) / MostPlaces) + 1;
        OutlineDifference[] differences =
        [
            .. samples.Where((_, number) => number % step == 0).AsParallel().AsOrdered().Select(sample => new OutlineDifference(
                MoonConstants.ReferenceRadius * sample.Direction,
                sample.Radius - MoonConstants.ReferenceRadius - _coarser(sample.Direction, cell),
                sample.Count * step * spacing)),
        ];
        return new OutlineField(differences, SamplesOfCell * spacing * step);
    }
}
