using Msisf.Core.Mesh;

namespace Msisf.Core.Render.Visibility;

/// <summary>A block that may be seen.</summary>
/// <param name="Block">Which.</param>
/// <param name="FirstRow">Image row, from 0, above which it is not seen.</param>
/// <param name="LastRow">Image row below which it is not seen.</param>
internal readonly record struct VisibleBlock(CellBlock Block, int FirstRow, int LastRow);
