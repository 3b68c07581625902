namespace Msisf.Adapters.Drawing;

/// <summary>Loads Skia, the library that draws and that decodes JPEG images; it comes with the program.</summary>
internal static class Skia
{
    /// <summary>Runs what uses Skia first.</summary>
    /// <exception cref="ExternalPartException">Its native library is missing or is one of another processor.</exception>
    public static T Guarded<T>(Func<T> use)
    {
        try
        {
            return use();
        }
        catch (Exception exception) when (
            (exception as TypeInitializationException)?.InnerException is DllNotFoundException or BadImageFormatException
                || exception is DllNotFoundException or BadImageFormatException)
        {
            throw new ExternalPartException(
                "libSkiaSharp, which draws on images and decodes JPEG, can't be loaded from the program's folder. Install msis again.",
                exception);
        }
    }
}
