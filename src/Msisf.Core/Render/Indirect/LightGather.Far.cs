using Msisf.Core.Numerics;

namespace Msisf.Core.Render.Indirect;

/// <content>Far ground.</content>
internal sealed partial class LightGather
{
    /// <summary>Points of far ground that a group chooses whose error is not known yet.</summary>
    public const int FirstChoices = 64;

    /// <summary>Parts of equal power of all far ground, each of which a first look finds seen or not.</summary>
    private const int Bins = 128;

    /// <summary>How much a part of far ground counts of which nothing was seen.</summary>
    private const double Unseen = 0.1;

    /// <summary>Chooses points of far ground: more of them where a first look finds that the group sees them.</summary>
    /// <param name="choices">How many points to choose.</param>
    /// <param name="round">Tells rounds of choices apart.</param>
    public void Choose(int choices, long round)
    {
        _choices = 0;
        if (_total == 0.0)
        {
            return;
        }

        SplitMix64 random = SplitMix64.For(0, purpose: 32, Group.Numbers[0], round);
        for (int bin = 0; bin < Bins; bin++)
        {
            int light = LightAt((bin + random.NextUniform()) / Bins * _total, out _);
            bool isSeen = SeenBy(light, 1UL << (int)(random.NextUniform() * Group.Count)) != 0;
            _binSums[bin + 1] = _binSums[bin] + (isSeen ? 1.0 : Unseen);
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
            _chosen[_choices++] = new Choice(light, 1.0 / (choices * chance), SeenBy(light, ulong.MaxValue));
        }
    }

    /// <summary>Adds the light of the chosen points to the points of the group that see them.</summary>
    /// <param name="found">Receives the light.</param>
    public void AddFar(GatheredLight found)
    {
        for (int receiver = 0; receiver < Group.Count && _choices > 0; receiver++)
        {
            Clear(_choices);
            for (int choice = 0; choice < _choices; choice++)
            {
                if (((_chosen[choice].Seen >> receiver) & 1) != 0)
                {
                    AddFar(receiver, choice, _chosen[choice].Light, _chosen[choice].Weight);
                }
            }

            Collect(receiver, _choices, found, isNear: false);
        }
    }

    /// <summary>The light at a place in the sum of what all may give, and its part of that sum.</summary>
    private int LightAt(double place, out double part)
    {
        int at = Array.BinarySearch(_sums, 0, lights.Bright.Length, place);
        at = Math.Min(at < 0 ? ~at : at + 1, lights.Bright.Length - 1);
        part = (_sums[at] - (at == 0 ? 0.0 : _sums[at - 1])) / _total;
        return lights.Bright[at];
    }

    /// <summary>Which of some points of the group see a light, as bits.</summary>
    private ulong SeenBy(int light, ulong receivers)
    {
        ulong ways = 0;
        for (int receiver = 0; receiver < Group.Count; receiver++)
        {
            Vector3D away = lights.Points[light] - Group.Points[receiver];
            bool isFacing = ((receivers >> receiver) & 1) != 0 && Vector3D.Dot(lights.Normals[light], away) < 0.0
                && Faces(receiver, away) && away.LengthSquared >= Group.Reaches[receiver] * Group.Reaches[receiver];
            ways |= isFacing ? 1UL << receiver : 0;
        }

        return ways == 0 ? 0 : tree.Reach(_fan, lights.Points[light], ways, Group.Count);
    }

    /// <summary>Adds the light of a point of far ground that is seen.</summary>
    private void AddFar(int receiver, int sample, int light, double weight)
    {
        Vector3D away = lights.Points[light] - Group.Points[receiver];
        double distance = Math.Sqrt(away.LengthSquared);
        Vector3D direction = away / distance;
        double emitted = -Vector3D.Dot(lights.Normals[light], direction);
        double solidAngle = weight * lights.Areas[light] * emitted / (distance * distance);
        Place place = new(lights.Points[light], lights.Normals[light], solidAngle * lights.Scales[light]);
        Add(receiver, sample, direction, place, lights.IsLit[light] ? lights.ToSun[light] : null, light);
    }

    /// <summary>A point of far ground that was chosen.</summary>
    /// <param name="Light">Which.</param>
    /// <param name="Weight">For how much of the far ground it stands.</param>
    /// <param name="Seen">The points of the group that see it, as bits.</param>
    private readonly record struct Choice(int Light, double Weight, ulong Seen);
}
