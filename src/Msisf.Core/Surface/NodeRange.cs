namespace Msisf.Core.Surface;

/// <summary>Neighbouring nodes of one level.</summary>
/// <param name="FirstRow">Northernmost row.</param>
/// <param name="EndRow">One past the southernmost row.</param>
/// <param name="FirstColumn">Westernmost column.</param>
/// <param name="EndColumn">One past the easternmost column.</param>
internal readonly record struct NodeRange(int FirstRow, int EndRow, int FirstColumn, int EndColumn);
