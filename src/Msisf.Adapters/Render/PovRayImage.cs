namespace Msisf.Adapters.Render;

/// <summary>What a run of POV-Ray gave.</summary>
/// <param name="Raster">The image.</param>
/// <param name="Times">POV-Ray's own times.</param>
public sealed record PovRayImage(PngRaster Raster, PovRayTimes Times);
