namespace Msisf.Core.Render.Visibility;

/// <summary>Rows of an image whose further samples are drawn together.</summary>
/// <param name="FirstRow">The first row, counted from 0.</param>
/// <param name="LastRow">The last row.</param>
/// <param name="Vectors">Number of vectors of <see cref="SamplePattern.Lanes"/> samples in them.</param>
internal readonly record struct SampledBand(int FirstRow, int LastRow, int Vectors);
