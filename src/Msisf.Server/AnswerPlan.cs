using Msisf.App.Settings;
using Msisf.Core.Layers;

namespace Msisf.Server;

/// <summary>What an answer will hold, known before anything is drawn.</summary>
/// <param name="HasImage">Whether the image is in it.</param>
/// <param name="Layers">Its layers; null for none.</param>
/// <param name="IsFits">Whether they are written as FITS.</param>
/// <param name="HasNumbers">Whether a detector's digital numbers are in it, as FITS.</param>
/// <param name="Meta">Content type of the meta file; null without.</param>
/// <param name="Bytes">Its length without compression.</param>
internal sealed record AnswerPlan(bool HasImage, LayerSet? Layers, bool IsFits, bool HasNumbers, string? Meta, long Bytes)
{
    /// <summary>bytes: longer answers are sent while they are made.</summary>
    public const long LargestInMemory = 64L << 20;

    private const long BytesOfAMegabyte = 1_000_000;
    private const string LayersNeeded = "names no layer; name them in 'layers'.";

    /// <summary>Whether the answer is too long to be kept in memory.</summary>
    public bool IsSentAsMade => Bytes > LargestInMemory;

    /// <summary>Plans an answer.</summary>
    /// <param name="settings">Options of the frame.</param>
    public static AnswerPlan Of(AnswerForm form, RenderSettings settings)
    {
        NativeSettings native = settings.Native;
        bool isLayer = native.Layers is not null && form.Main is AnswerForm.Raw or AnswerForm.Npy;
        bool isFits = form.IsMultipart ? native.LayersFormat == LayersFormat.Fits : form.Main == AnswerForm.Fits;
        bool hasImage = (!isLayer || form.HasBoth)
            && (form.IsMultipart || form.Main is AnswerForm.Png or AnswerForm.Raw or AnswerForm.Npy);
        LayerSet? layers = form.IsMultipart || isLayer || isFits ? native.Layers : null;
        bool hasNumbers = native.Detector is { } detector
            && (form.IsMultipart ? detector.WritesFits : native.Layers is null && isFits);
        string? meta = form.IsMultipart ? form.Meta : form.Main is AnswerForm.Xml or AnswerForm.Json ? form.Main : null;
        int bytesOfPixel = (hasImage ? native.Detector is null ? native.BitDepth / 8 : sizeof(ushort) : 0)
            + (layers?.Layers.Sum(layer => layer.Planes * layer.StoredType(native.LayersPrecision).Size()) ?? 0)
            + (hasNumbers ? sizeof(ushort) : 0);
        return new AnswerPlan(hasImage, layers, isFits, hasNumbers, meta, (long)settings.Width * settings.Height * bytesOfPixel);
    }

    /// <summary>Refuses what can't be answered.</summary>
    /// <param name="settings">Options of the frame.</param>
    /// <exception cref="RefusedException">The form does not fit the options, or the answer is too large.</exception>
    public void Check(AnswerForm form, RenderSettings settings, int maxMegabytes)
    {
        int layers = settings.Native.Layers?.Layers.Count ?? 0;
        if (settings.CameraFormats.FirstOrDefault(format => format.HasPixels) is { } wrong)
        {
            throw new RefusedException(
                StatusCodes.Status400BadRequest,
                $"'camera-model' {wrong.Word} holds the image too, and is for runs of msis. Leave it out.");
        }

        string? problem = form.Main switch
        {
            _ when settings.CameraFormats.Count > 0 && !form.IsMultipart =>
                $"'camera-model' is for answers of several parts, and {form.Main} is one. Accept {AnswerForm.Multipart}.",
            AnswerForm.Fits when layers == 0 && settings.Native.Detector is null =>
                $"{form.Main} is for layers, and the request {LayersNeeded}",
            AnswerForm.Raw or AnswerForm.Npy when layers > 1 =>
                $"{form.Main} holds one layer, and the request names {layers}. Accept {AnswerForm.Multipart}.",
            _ => null,
        };
        if (problem is not null)
        {
            throw new RefusedException(StatusCodes.Status406NotAcceptable, problem);
        }

        if (Bytes > maxMegabytes * BytesOfAMegabyte)
        {
            string fewer = Layers is null ? string.Empty : "fewer 'layers', 'layers-precision' single or ";
            throw new RefusedException(
                StatusCodes.Status413PayloadTooLarge,
                Invariant(
                    $"the answer has {Bytes / BytesOfAMegabyte} MB, more than the server's --max-megabytes of {maxMegabytes}. Ask for "
                        + $"{fewer}a smaller 'width' and 'height'."));
        }
    }
}
