namespace Msisf.Benchmarks.Measures;

/// <summary>What a child process has measured.</summary>
/// <param name="Threads">How many the renderer was given.</param>
/// <param name="HasVector512">The process used vectors of 512 bits.</param>
/// <param name="Resolution">Of the level of the model that was drawn, with its unit.</param>
/// <param name="FrameSeconds">Each measured frame.</param>
/// <param name="PeakMemoryBytes">Most memory of the process, file pages included.</param>
/// <param name="CheckedPixels">Pixels compared with the exact tracer.</param>
/// <param name="OtherFacets">How many of them show another facet.</param>
/// <param name="OtherLight">How many of them are lit otherwise.</param>
/// <param name="LargestDistance">m; between the two hits of a pixel, where both are on the same facet.</param>
internal sealed record FurtherFramesResult(
    int Threads,
    bool HasVector512,
    string Resolution,
    IReadOnlyList<double> FrameSeconds,
    long PeakMemoryBytes,
    int CheckedPixels,
    int OtherFacets,
    int OtherLight,
    double LargestDistance);
