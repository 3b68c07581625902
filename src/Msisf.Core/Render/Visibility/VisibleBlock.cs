using Msisf.Core.Camera;
using Msisf.Core.Mesh;

namespace Msisf.Core.Render.Visibility;

/// <summary>A block that may be seen.</summary>
/// <param name="Block">Which.</param>
/// <param name="Rows">Of the image; it is not seen above or below.</param>
internal readonly record struct VisibleBlock(CellBlock Block, PixelRows Rows);
