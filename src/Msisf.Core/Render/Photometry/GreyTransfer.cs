namespace Msisf.Core.Render.Photometry;

/// <summary>How linear grey is encoded in the levels of an image.</summary>
public enum GreyTransfer
{
    /// <summary>The sRGB curve (IEC 61966-2-1), for display; the PNG files of POV-Ray use it too.</summary>
    Srgb = 0,

    /// <summary>Levels proportional to radiance, for measurement.</summary>
    Linear = 1,
}
