namespace Msisf.Core.Sky;

/// <summary>The stars that a run draws. Immutable.</summary>
/// <param name="Stars">In the order of the file.</param>
public sealed record StarCatalogue(IReadOnlyList<Star> Stars)
{
    /// <summary>rad per Julian year: the greatest proper motion.</summary>
    private readonly double _fastest = Stars.Count == 0 ? 0.0 : Stars.Max(star => star.ProperMotion.Length);

    /// <summary>rad: aberration at 30 km/s and parallax of the nearest star, with room.</summary>
    private const double MostAberration = 2e-4;

    /// <summary>The stars that an observer may see within a circle of the sky, and few others.</summary>
    /// <param name="axis">Middle of the circle, length 1, ICRS.</param>
    /// <param name="radius">rad.</param>
    /// <param name="yearsPastJ2000">Julian years.</param>
    internal IEnumerable<Star> Near(Vector3D axis, double radius, double yearsPastJ2000)
    {
        double reach = radius + MostAberration;
        for (int i = 0; i < Stars.Count; i++)
        {
            Star star = Stars[i];
            double angle = reach + (_fastest * Math.Abs(yearsPastJ2000 - star.EpochYears));
            if (angle >= Math.PI || Vector3D.Dot(star.Direction, axis) >= Trigonometry.Cos(angle))
            {
                yield return star;
            }
        }
    }
}
