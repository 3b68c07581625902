using System.Collections.Concurrent;
using Msisf.Core.Terrain;

namespace Msisf.Core.Surface.Sources;

/// <summary>
/// How the models of a scene differ at their borders, and what they get from the finer ones in them (<see cref="OutlineField"/>). It is
/// found from the models themselves, and the same for all their levels of detail. Safe for several threads.
/// </summary>
internal sealed class OutlineFields
{
    /// <summary>Samples of a model from its border within which an outline counts as hidden by the model.</summary>
    private const int HiddenMargin = 2;

    private readonly IReadOnlyList<ITerrainGrid> _models;
    private readonly RawGround[] _grounds;
    private readonly Lazy<Outline>[] _outlines;
    private readonly ConcurrentDictionary<string, Lazy<OutlineField?>> _fields = new(StringComparer.Ordinal);

    /// <summary>Takes the models; nothing is read yet.</summary>
    /// <param name="models">The models, the coarsest first.</param>
    public OutlineFields(IReadOnlyList<ITerrainGrid> models)
    {
        _models = models;
        _grounds = [.. models.Select(model => new RawGround(model))];
        _outlines = [.. models.Select((model, part) => new Lazy<Outline>(
            () => new Outline(model, OutlineField.PieceOf(models[part - 1].Projection.Resolution.MetresPerPixel))))];
    }

    /// <summary>What a model gets; null for nothing.</summary>
    /// <param name="isDrawn">Which models there are; the others count for nothing.</param>
    public OutlineField? Of(int part, IReadOnlyList<bool> isDrawn)
    {
        bool[] finer = [.. isDrawn.Skip(part + 1)];
        string key = string.Concat(part.ToString(CultureInfo.InvariantCulture), ":", string.Concat(finer.Select(one => one ? '1' : '0')));
        return _fields.GetOrAdd(key, _ => new Lazy<OutlineField?>(() => NewField(part, isDrawn))).Value;
    }

    /// <summary>How far a model is off the coarser ones along its border, before any of them is changed.</summary>
    /// <param name="part">Number of the model; not the coarsest.</param>
    /// <returns>Null if its border lies on no coarser model.</returns>
    public BorderMisfit? MisfitOf(int part) => BorderMisfit.Of(_models[part], _outlines[part].Value, direction =>
    {
        for (int coarser = part - 1; coarser >= 0; coarser--)
        {
            if (_grounds[coarser].RadiusAt(direction) is { } radius)
            {
                return radius;
            }
        }

        return null;
    });

    /// <summary>The samples of a model's outline that lie on a coarser one and are seen, with the differences there.</summary>
    private IEnumerable<OutlineDifference> Differences(int part, int finer, IReadOnlyList<bool> isDrawn)
    {
        ITerrainGrid grid = _models[finer];
        OutlineField? own = Of(finer, isDrawn);
        RawGround[] hiding = [.. _grounds.Where((_, model) => model > part && model != finer && isDrawn[model])];
        foreach (OutlineSample sample in _outlines[finer].Value.Samples)
        {
            if (!Array.Exists(hiding, ground => ground.HasData(sample.Direction, HiddenMargin))
                && _grounds[part].RadiusAt(sample.Direction) is { } coarse)
            {
                yield return new OutlineDifference(
                    MoonConstants.ReferenceRadius * sample.Direction, sample.Radius + (own?.At(sample.Direction) ?? 0.0) - coarse,
                    sample.Count * grid.Projection.Resolution.MetresPerPixel);
            }
        }
    }

    private OutlineField? NewField(int part, IReadOnlyList<bool> isDrawn)
    {
        List<OutlineDifference> differences = [];
        for (int finer = part + 1; finer < _models.Count; finer++)
        {
            if (isDrawn[finer])
            {
                differences.AddRange(Differences(part, finer, isDrawn));
            }
        }

        return differences.Count == 0
            ? null
            : new OutlineField(differences, _models[part].Projection.Resolution.MetresPerPixel);
    }
}
