using Msisf.Core.Camera;
using Msisf.Core.Surface;

namespace Msisf.Core.Render.Visibility;

/// <summary>A cell block that may be visible in the image.</summary>
/// <param name="Block">The block.</param>
/// <param name="Rows">Image rows outside of which the block is not visible; not used with a lens.</param>
/// <param name="Tangents">The part of the ideal image plane outside of which the block is not visible; only used with a lens.</param>
internal readonly record struct VisibleBlock(CellBlock Block, PixelRows Rows, TangentBox Tangents);
