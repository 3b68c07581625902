namespace Msisf.Core.Render.Shadows;

/// <summary>The bounds of receivers that stand for others within a reach across the Sun's rays, and are as deep as the deepest.</summary>
internal sealed class ReachedReceivers(IReceiverBounds receivers, PartReach reach) : IReceiverBounds
{
    /// <inheritdoc/>
    public LightFrame Frame => receivers.Frame;

    /// <inheritdoc/>
    public LightBox Box => receivers.Box.Widened(reach.U, reach.V);

    /// <inheritdoc/>
    public double MaxDepth => receivers.MaxDepth;

    /// <inheritdoc/>
    public double MaxDepthIn(in LightBox box) => receivers.MaxDepthIn(box.Widened(reach.U, reach.V));
}
