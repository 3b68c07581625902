namespace Msisf.Core.Mesh;

/// <summary>
/// A block of mesh cells (<see cref="FacetMesh"/>); its vertices are the lines and samples from first to end, both included.
/// </summary>
/// <param name="FirstLine">Northernmost cell line; -1 is the northern fan.</param>
/// <param name="EndLine">One past the southernmost cell line.</param>
/// <param name="FirstSample">Westernmost cell.</param>
/// <param name="EndSample">One past the easternmost cell; may lie beyond the prime meridian.</param>
internal readonly record struct CellRange(int FirstLine, int EndLine, int FirstSample, int EndSample);
