namespace Msisf.Core.Surface;

/// <summary>A terrain that is more than one grid, and makes its surface itself.</summary>
internal interface ISurfaceSource
{
    /// <summary>The surface; made at the first request.</summary>
    /// <exception cref="Errors.BadInputException">The models can't be joined.</exception>
    SurfaceModel Surface { get; }

    /// <summary>The models with all their cells, the coarsest first.</summary>
    IReadOnlyList<GridPatch> WholeParts { get; }
}

/// <summary>A terrain that is more than one grid, and knows its heights itself.</summary>
internal interface IGround
{
    /// <summary>Distance from the Moon's centre to the ground in a direction, m.</summary>
    /// <param name="direction">Unit vector, body-fixed.</param>
    double RadiusAt(Vector3D direction);
}
