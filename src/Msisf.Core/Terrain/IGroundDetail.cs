namespace Msisf.Core.Terrain;

/// <summary>
/// Ground with invented detail below the resolution of elevation models. A height depends on the place and on the width of the cells that
/// show it, and on nothing else; detail that is too small for the cells is left out. Safe for several threads.
/// </summary>
public interface IGroundDetail
{
    /// <summary>Name of the invented parts of a surface, e.g. "REFINE_7".</summary>
    string Name { get; }

    /// <summary>Minimum and maximum radius that the ground can have, m, known without computing any.</summary>
    (double Min, double Max) RadiusLimits { get; }

    /// <summary>Radii at samples of a map.</summary>
    /// <param name="map">The map; its pixels are as wide as the cells, a power of two of metres.</param>
    /// <param name="firstLine">Top line.</param>
    /// <param name="firstSample">Leftmost sample.</param>
    /// <param name="side">Number of lines, and of samples of a line.</param>
    /// <param name="radii">Filled with m from the Moon's centre, line by line.</param>
    void ReadRadii(PolarStereographic map, int firstLine, int firstSample, int side, Span<double> radii);

    /// <summary>Factors of the ground's reflectance at samples of a map: rays of invented craters make it brighter.</summary>
    /// <param name="map">The map; its pixels are a power of two of metres wide.</param>
    /// <param name="firstLine">Top line.</param>
    /// <param name="firstSample">Leftmost sample.</param>
    /// <param name="side">Number of lines, and of samples of a line.</param>
    /// <param name="factors">Filled line by line; 1 in the mean over a large area.</param>
    void ReadBrightness(PolarStereographic map, int firstLine, int firstSample, int side, Span<float> factors);

    /// <summary>Radius in a direction, m.</summary>
    /// <param name="direction">Unit vector, body-fixed.</param>
    /// <param name="cell">m: width of the cells, a power of two.</param>
    double RadiusAt(Vector3D direction, double cell);
}
