using Msisf.Core.Render.Photometry;

namespace Msisf.Core.Render.Indirect;

/// <summary>
/// The light of far ground on the points of a group, by points that stand for it, which the group shares. First as if the group saw what
/// the pixels of a <see cref="SharedSight"/> see; then what it sees otherwise, by ways from each point. Together they are right in the
/// mean.
/// </summary>
/// <param name="lights">The points that stand for the ground.</param>
/// <param name="sight">The group.</param>
/// <param name="samples">Receives the points.</param>
/// <param name="law">The reflectance law.</param>
internal sealed class FarLight(GroundLights lights, GroupSight sight, LightSamples samples, IReflectance law)
{
    /// <summary>The golden section: numbers that follow each other by it are spread evenly between 0 and 1.</summary>
    private const double Golden = 0.618_033_988_749_894_9;

    /// <summary>How much a light counts of which the pixels around say the same, where what is seen otherwise is asked for.</summary>
    private const float Sure = 0.2f;

    private readonly LightPowers _powers = new(lights, law);
    private readonly float[] _given = new float[lights.Bright.PaddedLength];
    private readonly float[] _seen = new float[lights.Bright.PaddedLength];
    private readonly float[] _isUnsure = new float[lights.Bright.PaddedLength];
    private readonly double[] _sharedSums = new double[lights.Bright.Length];
    private readonly double[] _otherSums = new double[lights.Bright.Length];
    private Choice[] _chosen = [];

    /// <summary>Prepares the group that was set, which has begun.</summary>
    /// <param name="shared">What pixels see that lie far apart; null if that is not known.</param>
    /// <param name="x">Where in the image the group lies, px, from 0.</param>
    /// <param name="y">The same, down.</param>
    /// <returns>The light nearest to the group's middle, and its distance, m.</returns>
    public (int Light, double Distance) Begin(SharedSight? shared, double x, double y)
    {
        float[] powers = shared?.PowersTowards(x, y, _powers.Towards) ?? _powers.Towards(sight.Group.Middle);
        (int Light, double Distance) nearest = lights.Bright.Find(sight.Group, powers, _given);
        if (shared is null)
        {
            Array.Clear(_seen);
            Array.Fill(_isUnsure, 1.0f);
        }
        else
        {
            shared.Mix(x, y, _seen, _isUnsure);
        }

        (double ofShared, double ofOther) = (0.0, 0.0);
        for (int i = 0; i < _sharedSums.Length; i++)
        {
            ofShared += _given[i] * _seen[i];
            ofOther += _given[i] * (Sure + ((1.0f - Sure) * _isUnsure[i]));
            (_sharedSums[i], _otherSums[i]) = (ofShared, ofOther);
        }

        return nearest;
    }

    /// <summary>Adds the light as if the group saw what the pixels around it see.</summary>
    /// <param name="choices">How many points of far ground stand for all.</param>
    /// <param name="round">Tells rounds of choices apart.</param>
    /// <param name="found">Receives the light.</param>
    public void AddShared(int choices, long round, GatheredLight found) => Add(_sharedSums, choices, round, isOther: false, found);

    /// <summary>Adds what the points of the group see otherwise; the parameters are those of <see cref="AddShared"/>.</summary>
    public void AddOther(int choices, long round, GatheredLight found) => Add(_otherSums, choices, round, isOther: true, found);

    private void Add(double[] sums, int choices, long round, bool isOther, GatheredLight found)
    {
        double total = sums.Length == 0 ? 0.0 : sums[^1];
        if (total == 0.0)
        {
            return;
        }

        if (_chosen.Length < choices)
        {
            _chosen = new Choice[choices];
        }

        double offset = (0.5 + (round * Golden)) % 1.0; // the same for all groups: their errors differ little from their neighbours'
        for (int choice = 0; choice < choices; choice++)
        {
            int at = Array.BinarySearch(sums, (choice + offset) / choices * total);
            at = Math.Min(at < 0 ? ~at : at + 1, sums.Length - 1);
            double part = (sums[at] - (at == 0 ? 0.0 : sums[at - 1])) / total;
            int light = lights.Bright[at];
            ulong facing = sight.Facing(light);
            _chosen[choice] = new Choice(light, 1.0 / (choices * part), _seen[at], facing, isOther ? sight.Seeing(light, facing) : 0);
        }

        for (int receiver = 0; receiver < sight.Group.Count; receiver++)
        {
            samples.Clear(choices);
            for (int i = 0; i < choices; i++)
            {
                ref readonly Choice choice = ref _chosen[i];
                double seen = isOther ? ((choice.Seeing >> receiver) & 1) - choice.Shared : choice.Shared;
                if (((choice.Facing >> receiver) & 1) != 0 && seen != 0.0)
                {
                    Add(receiver, i, choice.Light, seen * choice.Weight);
                }
            }

            samples.SumUp(receiver, found, hasMap: true);
        }
    }

    private void Add(int receiver, int sample, int light, double weight)
    {
        Vector3D away = lights.Points[light] - sight.Group.Points[receiver];
        double distance = Math.Sqrt(away.LengthSquared);
        Vector3D direction = away / distance;
        double emitted = -Vector3D.Dot(lights.Normals[light], direction);
        double solidAngle = weight * lights.Areas[light] * emitted / (distance * distance);
        LitPlace place = new(lights.Points[light], lights.Normals[light], solidAngle * lights.Scales[light]);
        samples.Add(sight.Group, receiver, sample, direction, place, lights, light, lights.FromSun[light]);
    }

    /// <summary>A point of far ground that was chosen.</summary>
    /// <param name="Light">Which.</param>
    /// <param name="Weight">For how many it is.</param>
    /// <param name="Shared">How likely the pixels around see it.</param>
    /// <param name="Facing">The points of the group that face it, as bits.</param>
    /// <param name="Seeing">Those of them that see it; none if that is not asked for.</param>
    private readonly record struct Choice(int Light, double Weight, double Shared, ulong Facing, ulong Seeing);
}
