namespace Msisf.Adapters.Manifest;

/// <summary>What was found of a frame.</summary>
/// <param name="Expected">The frame.</param>
/// <param name="State">Its state.</param>
/// <param name="Reason">Why, in words; empty if it is complete.</param>
public sealed record FrameCheck(ExpectedRecord Expected, FrameState State, string Reason);
