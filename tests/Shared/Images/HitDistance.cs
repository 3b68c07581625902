using Msisf.Core.Numerics;

namespace Msisf.TestSupport.Images;

/// <summary>How far the points that pixels show are from those that they show in truth.</summary>
/// <param name="Pixels">Pixels that show the surface in both.</param>
/// <param name="OneSided">Pixels that show it in one of the two only.</param>
/// <param name="Median">m.</param>
/// <param name="Rms">m.</param>
/// <param name="Largest">m; at an edge another mountain may be met, kilometres away.</param>
internal readonly record struct HitDistance(int Pixels, int OneSided, double Median, double Rms, double Largest)
{
    /// <summary>Compares point by point.</summary>
    /// <param name="truth">m, MOON_ME; null where the pixel shows no surface.</param>
    /// <param name="points">Of the same pixels.</param>
    public static HitDistance Of(IReadOnlyList<Vector3D?> truth, IReadOnlyList<Vector3D?> points)
    {
        ArgumentOutOfRangeException.ThrowIfNotEqual(points.Count, truth.Count, nameof(points));
        List<double> distances = [];
        int oneSided = 0;
        for (int i = 0; i < truth.Count; i++)
        {
            if (truth[i] is Vector3D right && points[i] is Vector3D shown)
            {
                distances.Add((shown - right).Length);
            }
            else if (truth[i] is not null || points[i] is not null)
            {
                oneSided++;
            }
        }

        if (distances.Count == 0)
        {
            return new HitDistance(0, oneSided, 0.0, 0.0, 0.0);
        }

        distances.Sort();
        double meanSquare = distances.Sum(distance => distance * distance) / distances.Count;
        return new HitDistance(distances.Count, oneSided, distances[distances.Count / 2], Math.Sqrt(meanSquare), distances[^1]);
    }
}
