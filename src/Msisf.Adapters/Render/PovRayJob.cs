using Msisf.Core.Camera;

namespace Msisf.Adapters.Render;

/// <summary>One run of POV-Ray.</summary>
/// <param name="Scene">Writes the scene.</param>
/// <param name="PatternFolder">Folder of the patterns that the scene includes by file name.</param>
/// <param name="WorkFolder">An existing folder on the disk of the outputs, for POV-Ray's own files.</param>
/// <param name="Width">Image width, px.</param>
/// <param name="Height">Image height, px.</param>
/// <param name="Rows">The rows to draw, the others stay black; null for all.</param>
/// <param name="Threads">Threads that POV-Ray may use.</param>
/// <param name="Options">POV-Ray options after the usual ones, which they overrule.</param>
/// <param name="Timeout">Longest allowed run, or null for no limit.</param>
public sealed record PovRayJob(
    Action<TextWriter> Scene,
    string PatternFolder,
    string WorkFolder,
    int Width,
    int Height,
    PixelRows? Rows,
    int Threads,
    IReadOnlyList<string> Options,
    TimeSpan? Timeout);

/// <summary>What a run of POV-Ray gave.</summary>
/// <param name="Raster">The image.</param>
/// <param name="Times">POV-Ray's own times.</param>
public sealed record PovRayImage(PngRaster Raster, PovRayTimes Times);
