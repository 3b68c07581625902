namespace Msisf.Core.Render.Shadows;

/// <summary>Neighbouring facets of the <see cref="CasterStore"/> that come from one block.</summary>
/// <param name="First">Number of the first.</param>
/// <param name="Count">How many.</param>
/// <param name="LeastV">m in light space: no corner has less.</param>
/// <param name="GreatestV">m in light space: no corner has more.</param>
internal readonly record struct CasterRun(int First, int Count, double LeastV, double GreatestV);
