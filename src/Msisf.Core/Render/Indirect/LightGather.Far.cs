using Msisf.Core.Numerics;

namespace Msisf.Core.Render.Indirect;

/// <content>Far ground.</content>
internal sealed partial class LightGather
{
    /// <summary>Chooses points of far ground: more of them where a first look finds that the group sees them.</summary>
    /// <param name="looks">Rays of the first look.</param>
    /// <param name="choices">How many points to choose.</param>
    /// <param name="round">Tells rounds of samples apart.</param>
    public void Choose(int looks, int choices, long round)
    {
        _choices = 0;
        if (_total == 0.0)
        {
            return;
        }

        Span<double> seen = stackalloc double[Bins];
        SplitMix64 random = SplitMix64.For(0, purpose: 32, Group.Numbers[0], round);
        for (int look = 0; look < looks; look++)
        {
            double place = (look + random.NextUniform()) / looks;
            int bin = (int)(place * Bins);
            seen[bin] += IsSeen(AnyOf(ref random), LightAt(place * _total, out _)) ? (double)Bins / looks : 0.0;
        }

        for (int bin = 0; bin < Bins; bin++)
        {
            _binSums[bin + 1] = _binSums[bin] + Math.Min(1.0, seen[bin] + Unseen);
        }

        if (_chosen.Length < choices)
        {
            _chosen = new Choice[choices];
        }

        double offset = (0.5 + (round * Golden)) % 1.0; // the same for all groups: their errors differ little from their neighbours'
        int at = 0;
        for (int choice = 0; choice < choices; choice++)
        {
            double mass = (choice + offset) / choices * _binSums[Bins];
            while (at < Bins - 1 && _binSums[at + 1] <= mass)
            {
                at++;
            }

            double width = _binSums[at + 1] - _binSums[at];
            int light = LightAt((at + ((mass - _binSums[at]) / width)) / Bins * _total, out double part);
            double chance = part * Bins * width / _binSums[Bins]; // within a light that lies in two bins, that of the place counts
            _chosen[_choices++] = new Choice(light, 1.0 / (choices * chance), IsSeen(AnyOf(ref random), light));
        }
    }

    /// <summary>Adds the light of chosen points to the points of the group as if nothing hid it.</summary>
    /// <param name="areSeen">Whether of those that the group sees, or of the others.</param>
    /// <param name="found">Receives the light.</param>
    public void AddShared(bool areSeen, GatheredLight found)
    {
        for (int receiver = 0; receiver < Group.Count && _choices > 0; receiver++)
        {
            Clear(_choices);
            for (int choice = 0; choice < _choices; choice++)
            {
                if (_chosen[choice].IsSeen == areSeen)
                {
                    AddFar(receiver, choice, _chosen[choice].Light, _chosen[choice].Weight);
                }
            }

            Collect(receiver, _choices, found, isNear: false);
        }
    }

    private void AddDifference(int samples, long round, GatheredLight found)
    {
        for (int receiver = 0; receiver < Group.Count && _choices > 0; receiver++)
        {
            Clear(samples);
            double offset = SplitMix64.For(0, purpose: 34, Group.Numbers[receiver], round).NextUniform();
            for (int sample = 0; sample < samples; sample++)
            {
                Choice choice = _chosen[(int)((sample + offset) / samples * _choices)];
                bool isSeen = IsSeen(receiver, choice.Light);
                if (isSeen != choice.IsSeen)
                {
                    AddFar(receiver, sample, choice.Light, (isSeen ? choice.Weight : -choice.Weight) * _choices / samples);
                }
            }

            Collect(receiver, samples, found, isNear: false);
        }
    }

    private int AnyOf(ref SplitMix64 random) => (int)(random.NextUniform() * Group.Count);

    /// <summary>The light at a place in the sum of what all may give, and its part of that sum.</summary>
    private int LightAt(double place, out double part)
    {
        int at = Array.BinarySearch(_sums, 0, lights.Bright.Length, place);
        at = Math.Min(at < 0 ? ~at : at + 1, lights.Bright.Length - 1);
        part = (_sums[at] - (at == 0 ? 0.0 : _sums[at - 1])) / _total;
        return lights.Bright[at];
    }

    private bool IsSeen(int receiver, int light)
    {
        Vector3D point = Group.Points[receiver];
        Vector3D away = lights.Points[light] - point;
        double distance = Math.Sqrt(away.LengthSquared);
        Vector3D direction = away / distance;
        return distance >= Group.Reaches[receiver] && Vector3D.Dot(lights.Normals[light], direction) < 0.0
            && Vector3D.Dot(Group.Facets[receiver], direction) > 0.0 && !tree.IsBlocked(point, direction, distance - Gap);
    }

    /// <summary>Adds the light of a point of far ground as if nothing hid it.</summary>
    private void AddFar(int receiver, int sample, int light, double weight)
    {
        Vector3D away = lights.Points[light] - Group.Points[receiver];
        double distance = Math.Sqrt(away.LengthSquared);
        Vector3D direction = away / distance;
        double emitted = -Vector3D.Dot(lights.Normals[light], direction);
        if (distance >= Group.Reaches[receiver] && emitted > 0.0 && Faces(receiver, direction))
        {
            double solidAngle = weight * lights.Areas[light] * emitted / (distance * distance);
            Place place = new(lights.Points[light], lights.Normals[light], solidAngle * lights.Scales[light]);
            Add(receiver, sample, direction, place, lights.IsLit[light] ? lights.ToSun[light] : null, light);
        }
    }

    /// <summary>A point of far ground that was chosen.</summary>
    /// <param name="Light">Which.</param>
    /// <param name="Weight">For how much of the far ground it stands.</param>
    /// <param name="IsSeen">Whether a point of the group sees it.</param>
    private readonly record struct Choice(int Light, double Weight, bool IsSeen);
}
