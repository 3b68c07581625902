namespace Msisf.Core.Render.Indirect;

/// <summary>
/// Points of the ground that stand for all of it around a view, with the light on them. Neighbours in the list are mostly neighbours on
/// the ground. All vectors are body-fixed, lengths in m, light over the Sun's irradiance.
/// </summary>
/// <param name="count">Number of points.</param>
internal sealed class GroundLights(int count)
{
    /// <summary>Number of points.</summary>
    public int Count => count;

    /// <summary>The points.</summary>
    public Vector3D[] Points { get; } = new Vector3D[count];

    /// <summary>Normals of their facets, length 1.</summary>
    public Vector3D[] Normals { get; } = new Vector3D[count];

    /// <summary>m^2: area of the ground for which each is.</summary>
    public double[] Areas { get; } = new double[count];

    /// <summary>m: from each point, ground within this distance is looked at by rays instead.</summary>
    public double[] Reaches { get; } = new double[count];

    /// <summary>m: the same for the points that the view shows.</summary>
    public double ReachOfView { get; init; }

    /// <summary>By what the map of the reflectance multiplies the law's radiance factors.</summary>
    public double[] Scales { get; } = new double[count];

    /// <summary>Direction to the Sun, or to one of the points of its disc, which differ from point to point.</summary>
    public Vector3D[] ToSun { get; } = new Vector3D[count];

    /// <summary>
    /// The sunlight on the ground for which each is over what there would be if the Sun shone on all of it as it shines on the point.
    /// </summary>
    public double[] FromSun { get; } = new double[count];

    /// <summary>Mean direction from which the ground's own light comes.</summary>
    public Vector3D[] ToGround { get; } = new Vector3D[count];

    /// <summary>That light, on a plane across <see cref="ToGround"/>.</summary>
    public double[] FromGround { get; } = new double[count];

    /// <summary>The points that are not dark.</summary>
    public BrightLights Bright { get; private set; } = new([], [], []);

    /// <summary>Finds the bright points anew, after light was set.</summary>
    public void FindBright() => Bright = new BrightLights(
        [.. Enumerable.Range(0, count).Where(point => Scales[point] > 0.0 && FromSun[point] + FromGround[point] > 0.0)],
        Points, Normals);
}
